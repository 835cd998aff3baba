// SPDX-License-Identifier: MIT
// The choice of the processor that a world runs on.
#pragma once

#include "world/world.h"

namespace ballpit {

/// The backend of this name. Automatic: CUDA if there is a device and the response runs on it, else the CPU. Throws
/// UserError with the reason if the backend is not available.
Backend select_backend(BackendName name, Response response = Response::impulse);

}  // namespace ballpit
