// SPDX-License-Identifier: MIT
// Replaces the CUDA backend in programs built without the CUDA Toolkit.
#include "render/body_buffer.h"
#include "world/world.h"

namespace ballpit {

Backend cuda_backend() { return {"cuda", "this program was built without the CUDA Toolkit", "", nullptr, nullptr}; }

std::unique_ptr<BodyWriter> make_cuda_body_writer() { return nullptr; }

}  // namespace ballpit
