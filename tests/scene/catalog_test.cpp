// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "core/file.h"
#include "scene/read_scene.h"

using namespace ballpit;

namespace {

std::string default_of(const Scene& scene, std::string_view key) {
  for (const DefaultOption& option : scene.defaults) {
    if (option.key == key) return option.value;
  }
  return "";
}

}  // namespace

TEST_CASE("the catalog starts with the default scene and describes each in two languages") {
  REQUIRE(built_in_scenes().size() == 23);
  CHECK(built_in_scenes()[0].name == kDefaultScene);
  for (const SceneInfo& info : built_in_scenes()) {
    CAPTURE(info.name);
    CHECK_FALSE(info.title.empty());
    CHECK_FALSE(info.description.empty());
    CHECK(info.title_de != info.title);
    CHECK(info.description_de != info.description);
  }
}

TEST_CASE("every built-in scene loads, and declares its defaults and needs") {
  for (const SceneInfo& info : built_in_scenes()) {
    CAPTURE(info.name);
    const Scene scene = load_scene(info.name);
    CHECK(scene.name == info.name);
    CHECK(scene.bodies.size() > 0);
    CHECK_FALSE(default_of(scene, "broadphase").empty());
    CHECK_FALSE(default_of(scene, "response").empty());
    CHECK(scene.needs.duration > 0.0);
    CHECK(scene.needs.max_overlap.has_value());
  }
}

TEST_CASE(
    "in every built-in scene without swept contacts a free fall through the whole domain moves less than a radius a "
    "step") {
  for (const SceneInfo& info : built_in_scenes()) {
    CAPTURE(info.name);
    const Scene scene = load_scene(info.name);
    if (default_of(scene, "swept") == "on") continue;
    double fastest = 0.0;
    for (size_t i = 0; i < scene.bodies.position.size(); ++i) {
      const double height = scene.bodies.position[i].y - scene.domain.min.y;
      const double v = length(scene.bodies.velocity[i]);
      fastest = std::max(fastest, std::sqrt(v * v + 2.0 * length(scene.physics.gravity) * height));
    }
    const double smallest = *std::min_element(scene.bodies.radius.begin(), scene.bodies.radius.end());
    CHECK(fastest * std::stod(default_of(scene, "dt")) < smallest);
  }
}

TEST_CASE("the scenes contain what the lecture needs") {
  CHECK(load_scene("bouncing-balls").bodies.size() == 2000);
  CHECK(load_scene("open-box").domain.boundary == Boundary::open_top);
  CHECK(load_scene("rain").bodies.size() == 20'000);
  CHECK(load_scene("two-spheres").bodies.size() == 2);
  const Scene grid = load_scene("lecture-grid");
  CHECK(grid.domain.dimensions == 2);
  CHECK(grid.domain.max == Vec3d(5, 5, 0));
  CHECK(grid.bodies.size() == 20);
  CHECK(std::stod(default_of(grid, "cell-size")) * 2.0 * grid.bodies.radius[0] == 1.0);
  CHECK(std::floor(grid.bodies.position[0].x) + 5.0 * std::floor(grid.bodies.position[0].y) == 6.0);
}

TEST_CASE("a path that ends in .toml or has a slash is a file") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "ballpit-catalog-test";
  std::filesystem::create_directories(folder);
  write_file(folder / "mine.toml", "title = 'Mine'");
  write_file(folder / "rain", "title = 'Not the rain'");
  CHECK(load_scene((folder / "mine.toml").string()).title == "Mine");
  CHECK(load_scene((folder / "rain").string()).title == "Not the rain");
  CHECK_THROWS_WITH(load_scene("nowhere.toml"), Catch::Contains("nowhere.toml: found no readable file (No such file"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("an unknown scene is refused with the names of those that exist") {
  CHECK_THROWS_WITH(load_scene("bouncing-bal"),
                    "SCENE: found \"bouncing-bal\", allowed bouncing-balls, open-box, lecture-grid, lecture-sweep, "
                    "lecture-cells, lecture-contacts, "
                    "lecture-periodic, lecture-zero, lecture-warps, rain, "
                    "two-spheres, bouncing-ball, oblique-pair, pi, cradle, stack, mass-ratio, bullet, gas-thin, "
                    "gas-dense, cooling-gas, column, dense-bed, or a path that ends in .toml or contains a '/'");
  CHECK_THROWS_AS(load_scene(""), UserError);
}

TEST_CASE("an error in a built-in scene names its file") {
  SceneOverrides overrides;
  overrides.count = 10'000'000;
  CHECK_THROWS_WITH(load_scene("rain", overrides), Catch::StartsWith("rain.toml:21: [[fill]] count (--count): found"));
}
