// SPDX-License-Identifier: MIT
#include "choose/record.h"

#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file.h"
#include "scene/read_scene.h"

using namespace ballpit;

namespace {

const std::filesystem::path kFile = std::filesystem::temp_directory_path() / "ballpit-choice-test.json";

Scene gas() {
  return parse_scene(
      "[domain]\nboundary = \"periodic\"\n[physics]\nrestitution = 1\n[[fill]]\ncount = 100\nradius = 0.05\nspeed = 1\n"
      "[defaults]\nsubsteps = 3\n[needs]\nduration = 1\nmax_overlap = 0.1\n",
      "gas.toml");
}

}  // namespace

TEST_CASE("a choice that is written and read again has the same settings, and those to go on with") {
  const Scene scene = gas();
  const std::vector<GivenOption> given{{"response", "impulse"}};
  const Choice choice = choose({scene, given, 1});
  REQUIRE(choice.chosen);
  write_file(kFile, json_of(choice, "gas.toml", scene, given).dump());
  const Choice again = read_choice(kFile, scene, given);
  const auto options = [&](const Settings& settings) { return typed(options_of(settings, scene.defaults)); };
  CHECK(options(again.chosen->settings) == options(choice.chosen->settings));
  CHECK(again.chosen->settings.dt == choice.chosen->settings.dt);
  CHECK(again.chosen->largest_overlap == choice.chosen->largest_overlap);
  REQUIRE(again.dearer.size() == choice.dearer.size());
  for (size_t k = 0; k < choice.dearer.size(); ++k) CHECK(options(again.dearer[k]) == options(choice.dearer[k]));
  CHECK(again.tolerances.size() == 1);
}

TEST_CASE("a choice as JSON has what other programs look for") {
  const Scene scene = gas();
  const nlohmann::ordered_json json = json_of(choose({scene, {}, 1}), "gas.toml", scene, {});
  CHECK(json["numbers"]["count"] == 100);
  for (const auto& out : json["ruled_out"]) CHECK(out["method"].is_string());
  for (const auto& tried : json["tried"]) {
    CHECK(tried["options"].is_object());
    CHECK(tried["cost"].is_number());
    CHECK(tried["errors"].contains("max_overlap"));
    CHECK(tried["holds"].is_boolean());
  }
  CHECK(json["chosen"]["response"].is_string());
  CHECK(json["chosen"]["dt"].is_number());
  CHECK(json["command"].get<std::string>().starts_with("ballpit simulate gas.toml --"));
  CHECK(json["reason"].is_string());
}

TEST_CASE("a record that is none is wrong input") {
  for (const char* const text : {"nonsense", "[]", "{}", "{\"chosen\": null}"}) {
    write_file(kFile, text);
    CHECK_THROWS_AS(read_choice(kFile, gas(), {}), UserError);
  }
  write_file(kFile, "{\"chosen\": {\"zeal\": 1}}");
  CHECK_THROWS_WITH(read_choice(kFile, gas(), {}), Catch::Contains("zeal: found no option of this name"));
  std::filesystem::remove(kFile);
}
