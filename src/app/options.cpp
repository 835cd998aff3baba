// SPDX-License-Identifier: MIT
#include "app/options.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "core/error.h"
#include "core/file.h"
#include "render/coloring.h"
#include "render/overlays/overlay.h"
#include "render/theme.h"
#include "scene/catalog.h"

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

template <class Table>
std::vector<std::string> names_in(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry.name);
  return names;
}

}  // namespace

void SettingOptions::add_to(CommandOptions& command, const std::string& heading,
                            std::span<const std::string_view> names) {
  for (const SettingInfo& setting : setting_table()) {
    if (!names.empty() && std::find(names.begin(), names.end(), setting.name) == names.end()) continue;
    const std::string name(setting.name);
    CommandOption* option =
        command.add_option("--" + name, values_[name], std::string(setting.help) + ": " + setting.allowed());
    option->type_name(std::string(setting.value_name))->group(heading);
    options_.emplace_back(name, option);
  }
}

std::vector<GivenOption> SettingOptions::given() const {
  std::vector<GivenOption> result;
  for (const auto& [name, option] : options_) {
    if (option->is_given()) result.push_back({name, values_.find(name)->second});
  }
  return result;
}

void SceneArguments::add_to(CommandOptions& command) {
  scene_ = kDefaultScene;
  option_ = command.add_option("SCENE", scene_, "a built-in scene (see `ballpit list`) or a .toml file");
  option_->shows_default();
  settings_.add_to(command, "Simulation (default: what the scene asks for)");
}

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

void LookArguments::add_to(CommandOptions& command) {
  const auto add = [&](const char* name, std::string& text, const std::string& help, const char* type) {
    options_[name] = command.add_option(name, text, help)->type_name(type)->shows_default();
  };
  add("--overlay", overlays_, "what to draw over the spheres: none, or some of " + join(names_in(overlay_table())),
      "A,B,…");
  add("--color", coloring_, "what a sphere's colour says: " + join(names_in(coloring_table())), "NAME");
  add("--theme", theme_, join(names_in(themes())), "NAME");
  add("--ui-scale", ui_scale_, "size of the panel's text and widgets: 0.5 to 3", "FACTOR");
}

View LookArguments::view(const View& base) const {
  View result = base;
  const auto is_given = [&](const char* name) { return options_.at(name)->is_given(); };
  if (is_given("--overlay")) result.overlays = parse_overlays("--overlay", overlays_);
  if (is_given("--color")) result.coloring = parse_choice("--color", coloring_, names_in(coloring_table()));
  if (is_given("--theme")) result.theme = parse_choice("--theme", theme_, names_in(themes()));
  if (is_given("--ui-scale")) {
    result.ui_scale = static_cast<float>(
        parse_number("--ui-scale", ui_scale_, static_cast<double>(kSmallestUi), static_cast<double>(kLargestUi)));
  }
  return result;
}

PictureSize parse_size(const std::string& text) {
  const size_t cross = std::min(text.find('x'), text.size());
  const auto width = number_in_range<int>(text.substr(0, cross), 16, 16384);
  const auto height = number_in_range<int>(text.substr(std::min(cross + 1, text.size())), 16, 16384);
  if (!width || !height) throw UserError("--size", text, "WIDTHxHEIGHT, each from 16 to 16384");
  return {*width, *height};
}

}  // namespace ballpit
