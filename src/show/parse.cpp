// SPDX-License-Identifier: MIT
#include "show/parse.h"

#include <algorithm>

#include "core/error.h"
#include "core/file.h"
#include "render/overlays/overlay.h"

namespace ballpit {

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

std::string text_of(PictureSize size) { return fmt::format("{}x{}", size.width, size.height); }

PictureSize parse_size(const std::string& text) {
  constexpr Range kSides{16, 16384};
  const size_t cross = std::min(text.find('x'), text.size());
  const auto width = number_in(kSides, text.substr(0, cross));
  const auto height = number_in(kSides, text.substr(std::min(cross + 1, text.size())));
  if (!width || !height) throw UserError("--size", text, "WIDTHxHEIGHT, each from " + text_of(kSides));
  return {*width, *height};
}

}  // namespace ballpit
