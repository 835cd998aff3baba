// SPDX-License-Identifier: MIT
// The two kinds of failure that a user sees; `main` catches both, once. A bug is an assert, not one of these.
#pragma once

#include <stdexcept>
#include <string>

namespace ballpit {

/// The user's input is wrong. One line: file, line and key (or option), what was found, what is allowed. Exit status 2.
struct UserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Correct input, but the run could not go on: disk full, a sphere escaped, a device failed. Exit status 1.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Joins names for a message: "a, b, c".
template <class Range>
std::string join(const Range& names, const std::string& separator = ", ") {
  std::string result;
  for (const auto& name : names) {
    if (!result.empty()) result += separator;
    result += name;
  }
  return result;
}

}  // namespace ballpit
