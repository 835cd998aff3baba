// SPDX-License-Identifier: MIT
#include "show/options.h"

#include <algorithm>

#include "core/file.h"
#include "methods/methods.h"
#include "render/overlays/overlay.h"
#include "show/notes.h"

namespace ballpit {

const std::string& parse_choice(std::string_view option, const std::string& text,
                                const std::vector<std::string>& choices) {
  if (std::find(choices.begin(), choices.end(), text) != choices.end()) return text;
  throw UserError(option, text, join(choices));
}

std::vector<std::string> split_list(const std::string& text, char separator) {
  std::vector<std::string> items;
  for (size_t start = 0; start <= text.size();) {
    const size_t end = std::min(text.find(separator, start), text.size());
    items.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return items;
}

void reject_same_file(std::string_view option, const std::string& path, std::string_view name,
                      const std::string& other) {
  if (!is_same_file(path, other)) return;
  throw UserError(option, path + ", which is " + std::string(name) + " as well", "a file of its own");
}

std::vector<std::string> parse_names(std::string_view option, const std::string& text,
                                     const std::vector<std::string>& known, std::string_view alone) {
  std::vector<std::string> names = split_list(text);
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw UserError(option, name, fmt::format("{} alone, or some of {}, with commas between", alone, join(known)));
  }
  return names;
}

std::vector<std::string> parse_overlays(std::string_view option, const std::string& text) {
  return text == "none" ? std::vector<std::string>{} : parse_names(option, text, names_in(overlay_table()), "none");
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

void apply_given(Settings& settings, const std::vector<GivenOption>& given) {
  for (const GivenOption& option : given) apply_setting(settings, option.name, option.value, "--" + option.name);
}

void check_given(const Settings& settings, const std::vector<GivenOption>& given) {
  for (const GivenOption& option : given) {
    if (option.name == "response") continue;
    const std::string allowed = allowed_instead(settings.response, option.name, option.value);
    if (!allowed.empty()) throw UserError("--" + option.name, option.value, allowed);
  }
}

Settings combine(const std::vector<DefaultOption>& defaults, const std::vector<GivenOption>& given) {
  Settings settings;
  for (const DefaultOption& option : defaults) apply_setting(settings, option.key, option.value, option.where);
  const Response of_scene = settings.response;
  apply_given(settings, given);
  const Response response = settings.response;
  check_given(settings, given);
  Settings fitting;
  for (const DefaultOption& option : defaults) {
    const std::string allowed = allowed_instead(response, option.key, option.value);
    if (allowed.empty()) {
      apply_setting(fitting, option.key, option.value, option.where);
    } else if (response == of_scene) {
      throw UserError(option.where, option.value, allowed);
    }
  }
  apply_given(fitting, given);
  return fitting;
}

void warn_of_small_cells(const Settings& settings) {
  if (!can_miss_contacts(settings)) return;
  warn(fmt::format("--cell-size {:g}", *settings.cell_size),
       "below 1, the block of cells around a sphere does not reach all that touch it, so contacts are missed");
}

}  // namespace ballpit
