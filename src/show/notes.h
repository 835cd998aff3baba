// SPDX-License-Identifier: MIT
// Warnings and notes on standard error: "ballpit: warning: WHERE: WHAT". Errors, which end the program, are in
// core/error.h.
#pragma once

#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "scene/input_error.h"

namespace ballpit {

inline void print_note(const char* kind, std::string_view text) {
  std::cerr << "ballpit: " << kind << ": " << visible(text) << "\n";
}

/// The result may not be the intended one. `where` names an option, a file or a command.
inline void warn(std::string_view where, std::string_view what) {
  print_note("warning", fmt::format("{}: {}", where, what));
}

/// Information: "ballpit: note: WHERE: WHAT".
inline void note(std::string_view where, std::string_view what) {
  print_note("note", fmt::format("{}: {}", where, what));
}

/// Warns of each of Scene::notes: "FILE: WHAT".
inline void print_warnings(const std::vector<std::string>& notes) {
  for (const std::string& text : notes) print_note("warning", text);
}

}  // namespace ballpit
