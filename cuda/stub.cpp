// SPDX-License-Identifier: MIT
// Stands in for the CUDA backend in programs built without the CUDA Toolkit.
#include "simulate/world.h"

namespace ballpit {

Backend cuda_backend() { return {"cuda", "this program was built without the CUDA Toolkit", "", nullptr, nullptr}; }

}  // namespace ballpit
