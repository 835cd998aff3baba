// SPDX-License-Identifier: MIT
// Other programs that may be there.
#pragma once

#include <string>

namespace ballpit {

/// Where a program is on the PATH; empty if it is not.
std::string find_program(const std::string& name);

}  // namespace ballpit
