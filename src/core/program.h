// SPDX-License-Identifier: MIT
// Other programs on this machine.
#pragma once

#include <string>

namespace ballpit {

/// The path of a program on the PATH; empty if there is none.
std::string find_program(const std::string& name);

}  // namespace ballpit
