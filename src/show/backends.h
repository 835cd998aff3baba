// SPDX-License-Identifier: MIT
// The choice of the processor that a world runs on.
#pragma once

#include "world/world.h"

namespace ballpit {

/// The backend of this name; automatic takes CUDA where a device answers and the response runs there, else the CPU.
/// Throws UserError with the reason where the one asked for cannot serve.
Backend select_backend(BackendName name, Response response = Response::impulse);

}  // namespace ballpit
