// SPDX-License-Identifier: MIT
// What the user is to know while the program goes on, on standard error: "ballpit: warning: WHERE: WHAT". Errors, which end
// it, are in core/error.h.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ballpit {

/// The result may not be what was meant. `where` names an option, a file or a command.
void warn(std::string_view where, std::string_view what);

/// The same for what is as it was meant: "ballpit: note: WHERE: WHAT".
void note(std::string_view where, std::string_view what);

/// Warns of each: of what was read, as Scene::notes has it, "FILE: WHAT".
void tell_notes(const std::vector<std::string>& notes);

}  // namespace ballpit
