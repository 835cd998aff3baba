// SPDX-License-Identifier: MIT
// The two kinds of failure that a user sees; only `main` catches them. A bug is an assert instead.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ballpit {

/// The user's input is wrong: "WHERE: found FOUND, allowed ALLOWED", and "; HINT" if there is one. Exit status 2.
class UserError : public std::runtime_error {
 public:
  /// `where`: "--dt", "SCENE", a file, or a key with its file and line. An empty `found` becomes "nothing"; blanks are quoted.
  UserError(std::string_view where, std::string_view found, std::string_view allowed, std::string_view hint = {});

  /// The same error in a larger place: "OUTER: WHERE: found …".
  UserError inside(std::string_view outer) const;

 private:
  std::string where_, found_, allowed_, hint_;
};

/// The input is correct, but the run had to stop: disk full, a sphere escaped, a device failed. "WHERE: WHAT HAPPENED", and
/// "; MORE": a remedy, or what was saved. Exit status 1.
class RunError : public std::runtime_error {
 public:
  /// `where` names a file, a step, a device or a library ("OpenGL"), or the scene.
  RunError(std::string_view where, std::string_view what_happened, std::string_view more = {});

  /// The same failure in a larger place: "OUTER: WHERE: …". The same place is not named twice.
  RunError inside(std::string_view outer) const;

  /// The same failure with "; MORE" at its end, unless `more` is empty.
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

/// The names of a table's entries.
template <class Table>
std::vector<std::string> names_in(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry.name);
  return names;
}

/// The entry of a table with this name. Throws UserError that lists the names of the table.
template <class Table>
const auto& entry_named(const Table& table, std::string_view name, std::string_view option) {
  for (const auto& entry : table) {
    if (entry.name == name) return entry;
  }
  throw UserError(option, name, join(names_in(table)));
}

}  // namespace ballpit
