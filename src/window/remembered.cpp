// SPDX-License-Identifier: MIT
#include "window/remembered.h"

#include <cmath>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "core/file.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

constexpr int kVersion = 1;  // of the file; others are not read

float number_at(const Json& view, const char* key, const Range<float>& range) {
  const float number = view.at(key).get<float>();
  if (number >= range.low && number <= range.high) return number;
  throw UserError(key, view.at(key).dump(), text_of(range));
}

View view_from(const Json& json) {
  constexpr float kTurn = 6.2832f;
  View view;
  view.azimuth = number_at(json, "azimuth", {-kTurn, kTurn});
  view.elevation = number_at(json, "elevation", {-kTurn, kTurn});
  view.zoom = number_at(json, "zoom", {kMinZoom, kMaxZoom});
  view.ui_scale = number_at(json, "ui_scale", {kMinUiScale, kMaxUiScale});
  if (json.contains("text_scale")) view.text_scale = number_at(json, "text_scale", {kMinUiScale, kMaxUiScale});
  if (json.contains("turn")) view.turn = number_at(json, "turn", {-kFastestTurn, kFastestTurn});
  view.has_caption = json.value("caption", true);
  view.occlusion = json.value("occlusion", true);
  view.overlays = parse_overlays("overlays", json.at("overlays").get<std::string>());
  view.coloring = coloring_named(json.at("color").get<std::string>()).name;
  view.theme = theme_named(json.at("theme").get<std::string>()).name;
  return view;
}

Remembered remembered_from(const Json& json) {
  if (json.at("version") != kVersion) throw UserError("version", json.at("version").dump(), std::to_string(kVersion));
  Remembered result;
  result.scene = json.at("scene").get<std::string>();
  for (const auto& [name, value] : json.at("options").items()) {
    result.given.push_back({name, value.get<std::string>()});
    Settings settings;
    apply_setting(settings, name, result.given.back().value, name);
  }
  result.view = view_from(json.at("view"));
  result.size = parse_size(json.at("size").get<std::string>());
  return result;
}

}  // namespace

std::filesystem::path remembered_file() {
  const auto folder = [](const char* variable) {
    const char* const value = std::getenv(variable);
    return std::filesystem::path(value ? value : "");
  };
  const std::filesystem::path config = folder("XDG_CONFIG_HOME"), home = folder("HOME");
  if (config.is_absolute()) return config / "ballpit" / "show.json";  // the standard ignores other ones
  if (!home.empty()) return home / ".config" / "ballpit" / "show.json";
  throw UserError("--remember", "neither XDG_CONFIG_HOME nor HOME in the environment",
                  "one of them, which says where to keep it");
}

std::optional<Remembered> read_remembered(const std::filesystem::path& file) {
  std::error_code unreadable;  // then read_file() says why
  if (!std::filesystem::exists(file, unreadable) && !unreadable) return std::nullopt;
  try {
    return remembered_from(Json::parse(read_file(file)));
  } catch (const Json::exception&) {
    throw UserError(file.string(), "something else", "what `ballpit show --remember` writes");
  } catch (const UserError& error) {
    throw error.inside(file.string());
  }
}

void check_remembered(const std::filesystem::path& file) {
  check_output_folder(file.parent_path());
  if (std::filesystem::exists(file.parent_path())) check_output(file);
}

void write_remembered(const std::filesystem::path& file, const Remembered& remembered) {
  const View& view = remembered.view;
  Json options = Json::object();
  for (const GivenOption& option : remembered.given) options[option.name] = option.value;
  const Json json{{"version", kVersion},
                  {"scene", remembered.scene},
                  {"options", options},
                  {"view",
                   {{"azimuth", view.azimuth},
                    {"elevation", view.elevation},
                    {"zoom", view.zoom},
                    {"turn", view.turn},
                    {"ui_scale", view.ui_scale},
                    {"text_scale", view.text_scale},
                    {"caption", view.has_caption},
                    {"occlusion", view.occlusion},
                    {"overlays", view.overlays.empty() ? "none" : join(view.overlays, ",")},
                    {"color", view.coloring},
                    {"theme", view.theme}}},
                  {"size", text_of(remembered.size)}};
  make_folder(file.parent_path());
  write_file(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace ballpit
