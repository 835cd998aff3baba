// SPDX-License-Identifier: MIT
// What the user is to know about input that was read, on standard error.
#pragma once

#include <string>
#include <vector>

namespace ballpit {

/// Prints a line for each.
void tell_notes(const std::vector<std::string>& notes);

}  // namespace ballpit
