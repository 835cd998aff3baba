// SPDX-License-Identifier: MIT
// What `show --remember` keeps.
#include "window/remembered.h"

#include <cstdlib>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "tests/support/run_program.h"

using namespace ballpit;

namespace {

Remembered some() {
  Remembered some{"rain", {{"broadphase", "sorted-grid"}, {"dt", "0.002"}}, {}, {1280, 720}};
  some.view.azimuth = 0.25f;
  some.view.zoom = 2;
  some.view.ui_scale = 1.5f;
  some.view.has_caption = false;
  some.view.turn = 12;
  some.view.overlays = {"pairs", "swept"};
  some.view.coloring = "work";
  some.view.theme = "dark";
  return some;
}

}  // namespace

TEST_CASE("scene, options, view and size come back as they were") {
  const Scratch scratch;
  const std::string file = scratch / "new/folder/show.json";
  CHECK_FALSE(read_remembered(file));
  write_remembered(file, some());
  const auto back = read_remembered(file);
  REQUIRE(back);
  CHECK(back->scene == "rain");
  REQUIRE(back->given.size() == 2);
  CHECK(back->given[1].name == "dt");
  CHECK(back->given[1].value == "0.002");
  CHECK(text_of(back->size) == "1280x720");
  const View view = some().view;
  CHECK(back->view.azimuth == view.azimuth);
  CHECK(back->view.zoom == view.zoom);
  CHECK(back->view.ui_scale == view.ui_scale);
  CHECK_FALSE(back->view.has_caption);
  CHECK(back->view.turn == 12);
  CHECK(back->view.overlays == view.overlays);
  CHECK(back->view.coloring == view.coloring);
  CHECK(back->view.theme == view.theme);
  Remembered bare = some();
  bare.view.overlays.clear();
  write_remembered(file, bare);
  CHECK(read_remembered(file)->view.overlays.empty());
}

TEST_CASE("a remembered file that is damaged, of another version or with unknown names is reported by its name") {
  const Scratch scratch;
  const std::string file = scratch / "show.json";
  write_remembered(file, some());
  const std::string good = read_text(file);
  const auto with = [&](const std::string& what, const std::string& instead) {
    std::string text = good;
    text.replace(text.find(what), what.size(), instead);
    return text;
  };
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[1, 2]"), good.substr(0, good.size() / 2),
        with("\"version\": 1", "\"version\": 99"), with("\"dark\"", "\"pink\""), with("pairs", "mood"),
        with("\"zoom\": 2.0", "\"zoom\": 1e30"), with("\"zoom\": 2.0", "\"zoom\": \"near\""), with("0.002", "much"),
        with("1280x720", "0x0"), with("broadphase", "no-such-option"), with("\"work\"", "7")}) {
    INFO(text);
    write_text(file, text);
    CHECK_THROWS_AS(read_remembered(file), UserError);
    CHECK_THROWS_WITH(read_remembered(file), Catch::Contains(file));
  }
}

TEST_CASE("the file is where the standard for configuration says") {
  const Variable home("HOME", "/home/someone");
  {
    const Variable config("XDG_CONFIG_HOME", "/etc/own");
    CHECK(remembered_file() == "/etc/own/ballpit/show.json");
  }
  const Variable config("XDG_CONFIG_HOME", "not/absolute");
  CHECK(remembered_file() == "/home/someone/.config/ballpit/show.json");
  const Variable none("HOME", "");
  CHECK_THROWS_AS(remembered_file(), UserError);
}
