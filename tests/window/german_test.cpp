// SPDX-License-Identifier: MIT
// Whatever the audience reads has a German text.
#include <filesystem>
#include <regex>

#include <catch2/catch.hpp>

#include "core/file.h"
#include "core/language.h"
#include "methods/methods.h"
#include "render/overlays/overlay.h"
#include "scene/read_scene.h"
#include "window/lecture_window.h"
#include "window/show_window.h"

using namespace ballpit;

namespace {

void check(std::string_view text) {
  CAPTURE(text);
  CHECK(has_german(text));
}

}  // namespace

TEST_CASE("German readers have a text for whatever a table shows") {
  for (const OverlayEntry& overlay : overlay_table()) check(overlay.label);
  for (const ColoringEntry& coloring : coloring_table()) check(coloring.label);
  for (const Theme& theme : themes()) check(theme.label);
  for (const Key& key : key_table()) check(key.help);
  for (const WindowKey& key : window_keys()) check(key.help);
  for (const std::string_view gesture : hand_gestures()) check(gesture);
  for (const PresenterKey& key : presenter_keys()) check(key.help);
  for (const PlayedError& error : played_errors()) check(error.label);
  check(find_method(Response::automatic).label);
  check("choosing…");
  for (const Method& method : methods()) {
    if (method.family == Family::broadphase && !is_of_lecture(named<BroadPhase>(method.name))) check(method.label);
  }
  for (const SettingInfo& setting : setting_table()) {
    if (setting.group != SettingGroup::run && setting.name != "broadphase") check(setting.help);
  }
  for (const SceneInfo& scene : built_in_scenes()) CHECK(scene.title_de != scene.title);
}

TEST_CASE("German readers have a text for each that the sources of picture, panel, report and choice show") {
  const std::regex shown(R"re((?:translated|phrase|note|row|heading|hint|title)\("([^"]+)")re");
  int texts = 0;
  for (const char* folder : {"/src/choose", "/src/lab", "/src/render", "/src/show", "/src/window"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(BALLPIT_SOURCE_DIR + std::string(folder))) {
      if (!entry.is_regular_file() || entry.path().extension() != ".cpp") continue;
      const std::string source = read_file(entry.path());
      const auto is_of_items = entry.path().filename() == "panel_settings.cpp";
      for (std::sregex_iterator at(source.begin(), source.end(), shown), end; at != end; ++at) {
        const std::string text = (*at)[1], call = (*at)[0];
        const bool names_item = call.starts_with("note") && entry.path().parent_path().filename() == "window";
        if (names_item || is_of_items) continue;  // note() names an item of the panel there
        CAPTURE(entry.path().string());
        check(text);
        ++texts;
      }
    }
  }
  CHECK(texts > 60);
}
