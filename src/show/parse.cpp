// SPDX-License-Identifier: MIT
#include "show/parse.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "core/error.h"
#include "core/file.h"
#include "render/overlays/overlay.h"

namespace ballpit {

namespace {

template <class T>
std::optional<T> number_in_range(std::string_view text, T low, T high) {
  T value{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || !(value >= low && value <= high)) return std::nullopt;
  return value;
}

template <class T>
T parse_in_range(std::string_view option, const std::string& text, T low, T high, const char* kind) {
  const std::optional<T> value = number_in_range(text, low, high);
  if (!value) {
    std::ostringstream allowed;
    allowed << kind << " from " << low << " to " << high;
    throw UserError(option, text, allowed.str());
  }
  return *value;
}

}  // namespace

int64_t parse_integer(std::string_view option, const std::string& text, int64_t low, int64_t high) {
  return parse_in_range(option, text, low, high, "an integer");
}

double parse_number(std::string_view option, const std::string& text, double low, double high) {
  return parse_in_range(option, text, low, high, "a number");
}

const std::string& parse_choice(std::string_view option, const std::string& text,
                                const std::vector<std::string>& choices) {
  if (std::find(choices.begin(), choices.end(), text) != choices.end()) return text;
  throw UserError(option, text, join(choices));
}

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> items;
  for (size_t start = 0; start <= text.size();) {
    const size_t end = std::min(text.find(',', start), text.size());
    items.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return items;
}

const std::string& parse_path(std::string_view option, const std::string& text) {
  if (!text.empty()) return text;
  throw UserError(option, "nothing", "a path");
}

const std::string& parse_output(std::string_view option, const std::string& text) {
  check_output(parse_path(option, text));
  return text;
}

void reject_same_file(std::string_view option, const std::string& path, std::string_view name,
                      const std::string& other) {
  if (!is_same_file(path, other)) return;
  throw UserError(option, path + ", which is " + std::string(name) + " as well", "a file of its own");
}

std::vector<std::string> parse_overlays(std::string_view option, const std::string& text) {
  const std::vector<std::string> known = names_in(overlay_table());
  std::vector<std::string> overlays = text == "none" ? std::vector<std::string>{} : split_list(text);
  for (const std::string& name : overlays) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw UserError(option, name, "none alone, or some of " + join(known) + ", with commas between");
  }
  return overlays;
}

PictureSize parse_size(const std::string& text) {
  const size_t cross = std::min(text.find('x'), text.size());
  const auto width = number_in_range<int>(text.substr(0, cross), 16, 16384);
  const auto height = number_in_range<int>(text.substr(std::min(cross + 1, text.size())), 16, 16384);
  if (!width || !height) throw UserError("--size", text, "WIDTHxHEIGHT, each from 16 to 16384");
  return {*width, *height};
}

}  // namespace ballpit
