// SPDX-License-Identifier: MIT
// Values of options as they are typed. All throw UserError with the option, what was found and what is allowed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ballpit {

/// The names of a table's entries.
template <class Table>
std::vector<std::string> names_in(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry.name);
  return names;
}

/// An integer in [low, high]. Throws UserError naming the option.
int64_t parse_integer(std::string_view option, const std::string& text, int64_t low, int64_t high);

/// A number in [low, high]. Throws UserError naming the option.
double parse_number(std::string_view option, const std::string& text, double low, double high);

/// One of `choices`. Throws UserError naming the option.
const std::string& parse_choice(std::string_view option, const std::string& text,
                                const std::vector<std::string>& choices);

/// The items of a list "a,b,c"; an empty one is an item, too.
std::vector<std::string> split_list(const std::string& text);

/// Names of overlays, "a,b,c", or "none". Throws UserError naming the option.
std::vector<std::string> parse_overlays(std::string_view option, const std::string& text);

/// A path that is not empty. Throws UserError naming the option.
const std::string& parse_path(std::string_view option, const std::string& text);

/// The path of an output, looked at before any work is done. Throws UserError where it is empty, RunError where it cannot be
/// written.
const std::string& parse_output(std::string_view option, const std::string& text);

/// Throws UserError where an output leads to the same place as a file that `name` is given.
void reject_same_file(std::string_view option, const std::string& path, std::string_view name,
                      const std::string& other);

struct PictureSize {
  int width;
  int height;
};

/// "1280x720". Throws UserError.
PictureSize parse_size(const std::string& text);

}  // namespace ballpit
