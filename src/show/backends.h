// SPDX-License-Identifier: MIT
// The processors that a world can run on, and the choice among them.
#pragma once

#include <string>

#include "world/world.h"

namespace ballpit {

/// The backend that --backend asks for. "auto" takes CUDA where a device answers, else the CPU.
/// Throws UserError with the reason where the one asked for cannot serve.
Backend select_backend(const std::string& name, const std::string& response = "impulse");

}  // namespace ballpit
