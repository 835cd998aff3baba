// SPDX-License-Identifier: MIT
// The two kinds of failure that a user sees; `main` catches both, once. A bug is an assert, not one of these. Each message
// has one form, which its constructor makes: nobody writes it by hand.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace ballpit {

/// The user's input is wrong: "WHERE: found FOUND, allowed ALLOWED", and "; HINT" where there is one. Exit status 2.
class UserError : public std::runtime_error {
 public:
  /// `where` names an option ("--dt"), an argument ("SCENE"), a file, or a key with its file and line. An empty `found` reads
  /// "nothing"; blanks are put in quotes.
  UserError(std::string_view where, std::string_view found, std::string_view allowed, std::string_view hint = {});

  /// The same error in a larger place: "OUTER: WHERE: found …".
  UserError inside(std::string_view outer) const;

 private:
  std::string where_, found_, allowed_, hint_;
};

/// Correct input, but the run could not go on: disk full, a sphere escaped, a device failed. "WHERE: WHAT HAPPENED", and
/// "; MORE": what helps, or what is left. Exit status 1.
class RunError : public std::runtime_error {
 public:
  /// `where` names a file, a step, a device or a library ("OpenGL"), or the scene.
  RunError(std::string_view where, std::string_view what_happened, std::string_view more = {});

  /// The same failure in a larger place: "OUTER: WHERE: …". A place is not named twice.
  RunError inside(std::string_view outer) const;

  /// With "; MORE" at its end, unless that is empty.
  RunError with(std::string_view more) const;

 private:
  std::string where_, what_happened_, more_;
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
