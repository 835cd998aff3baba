// SPDX-License-Identifier: MIT
// Warnings and notes on standard error: "ballpit: warning: WHERE: WHAT". Errors, which end the program, are in
// core/error.h.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ballpit {

/// The result may not be the intended one. `where` names an option, a file or a command.
void warn(std::string_view where, std::string_view what);

/// Information: "ballpit: note: WHERE: WHAT".
void note(std::string_view where, std::string_view what);

/// Warns of each of Scene::notes: "FILE: WHAT".
void print_warnings(const std::vector<std::string>& notes);

}  // namespace ballpit
