// SPDX-License-Identifier: MIT
#include "show/notes.h"

#include <iostream>

#include <fmt/format.h>

#include "scene/input_error.h"

namespace ballpit {

namespace {

void print(const char* kind, std::string_view text) {
  std::cerr << "ballpit: " << kind << ": " << visible(text) << "\n";
}

}  // namespace

void warn(std::string_view where, std::string_view what) { print("warning", fmt::format("{}: {}", where, what)); }

void note(std::string_view where, std::string_view what) { print("note", fmt::format("{}: {}", where, what)); }

void print_warnings(const std::vector<std::string>& notes) {
  for (const std::string& text : notes) print("warning", text);
}

}  // namespace ballpit
