// SPDX-License-Identifier: MIT
#include "scene/read_scene.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "core/file.h"

using namespace ballpit;

TEST_CASE("every value of a scene file arrives") {
  const Scene scene = parse_scene(R"(
title = "T"
description = "D"
title_de = "Td"
description_de = "Dd"
[domain]
min = [-1, -2, -3]
max = [1, 2, 3]
boundary = "open-top"
[physics]
gravity = [0, -9.81, 1]
restitution = 0.5
wall_restitution = 0.25
stiffness = 2e5
law = "hertz"
shear = 3
initial_overlap = 0.01
density = 500
[[spheres]]
position = [0.5, 5, 0.25]
velocity = [1, 2, 3]
radius = 0.125
mass = 4
[defaults]
broadphase = "linked-cell"
dt = 0.001
substeps = 4
some-flag = true
[needs]
duration = 3
max_overlap = 0.1
energy_tolerance = 0.2
max_speed = 0.3
)",
                                  "folder/my-scene.toml");
  CHECK(scene.name == "my-scene");
  CHECK(scene.title == "T");
  CHECK(scene.description == "D");
  CHECK(scene.title_de == "Td");
  CHECK(scene.description_de == "Dd");
  CHECK(scene.domain.min == Vec3d(-1, -2, -3));
  CHECK(scene.domain.max == Vec3d(1, 2, 3));
  CHECK(scene.domain.boundary == Boundary::open_top);
  CHECK(scene.domain.dimensions == 3);
  CHECK(scene.physics.gravity == Vec3d(0, -9.81, 1));
  CHECK(scene.physics.restitution == 0.5);
  CHECK(scene.physics.wall_restitution == 0.25);
  CHECK(scene.physics.stiffness == 2e5);
  CHECK(scene.physics.law == "hertz");
  CHECK(scene.physics.shear == 3.0);
  CHECK(scene.physics.initial_overlap == 0.01);
  CHECK(scene.physics.density == 500.0);
  REQUIRE(scene.bodies.size() == 1);
  CHECK(scene.bodies.position[0] == Vec3d(0.5, 5, 0.25));
  CHECK(scene.bodies.velocity[0] == Vec3d(1, 2, 3));
  CHECK(scene.bodies.radius[0] == 0.125);
  CHECK(scene.bodies.mass[0] == 4.0);
  REQUIRE(scene.defaults.size() == 4);
  CHECK(scene.needs.duration == 3.0);
  CHECK(scene.needs.max_overlap == 0.1);
  CHECK(scene.needs.energy_tolerance == 0.2);
  CHECK(scene.needs.max_speed == 0.3);
  CHECK(scene.seed == 1);
}

TEST_CASE("an empty scene is a unit box without spheres or gravity") {
  const Scene scene = parse_scene("", "empty.toml");
  CHECK(scene.bodies.size() == 0);
  CHECK(scene.title == "empty");
  CHECK(scene.domain.max == Vec3d(1, 1, 1));
  CHECK(scene.domain.boundary == Boundary::walls);
  CHECK(scene.physics.gravity == Vec3d(0, 0, 0));
  CHECK(scene.physics.wall_restitution == scene.physics.restitution);
  CHECK(parse_scene("[[fill]]\ncount = 0\nradius = 0.1", "a.toml").bodies.size() == 0);
}

TEST_CASE("the walls take the spheres' restitution unless they have their own") {
  CHECK(parse_scene("[physics]\nrestitution = 0.3", "a.toml").physics.wall_restitution == 0.3);
}

TEST_CASE("defaults are kept as they would be typed, with their place") {
  const Scene scene = parse_scene(
      "[defaults]\nbroadphase = 'sort-and-sweep'\ndt = 0.004166667\nsubsteps = 4\npanel = true\ncell-size = "
      "2.0",
      "f.toml");
  std::vector<std::string> typed;
  for (const DefaultOption& option : scene.defaults) typed.push_back(option.where + " = " + option.value);
  std::sort(typed.begin(), typed.end());
  CHECK(typed == std::vector<std::string>{"f.toml:2: [defaults] broadphase = sort-and-sweep",
                                          "f.toml:3: [defaults] dt = 0.004166667", "f.toml:4: [defaults] substeps = 4",
                                          "f.toml:5: [defaults] panel = true", "f.toml:6: [defaults] cell-size = 2"});
}

TEST_CASE("mass defaults to density times the volume of the sphere, in the plane too") {
  const double volume = 4.0 / 3.0 * 3.14159265358979323846 * 0.001;
  for (const std::string dimensions : {"2", "3"}) {
    const Scene scene =
        parse_scene("[domain]\ndimensions = " + dimensions +
                        "\n[physics]\ndensity = 7\n[[spheres]]\nposition = [0.5, 0.5, 0.5]\nradius = 0.1",
                    "a.toml");
    CHECK(scene.bodies.mass[0] == Approx(7.0 * volume).epsilon(1e-14));
  }
}

TEST_CASE("a planar scene takes two or three coordinates and keeps two") {
  const Scene scene = parse_scene(R"(
[domain]
min = [0, 0, -7]
max = [2, 2]
dimensions = 2
[physics]
gravity = [0, -1, -1]
[[spheres]]
position = [0.5, 0.5]
velocity = [1, 2]
radius = 0.1
[[spheres]]
position = [1.5, 0.5, 99]
velocity = [1, 2, 3]
radius = 0.1
)",
                                  "a.toml");
  CHECK(scene.domain.min == Vec3d(0, 0, 0));
  CHECK(scene.domain.max == Vec3d(2, 2, 0));
  CHECK(scene.physics.gravity == Vec3d(0, -1, 0));
  CHECK(scene.bodies.position[1] == Vec3d(1.5, 0.5, 0));
  CHECK(scene.bodies.velocity[1] == Vec3d(1, 2, 0));
}

TEST_CASE("spheres may touch, and overlap as far as the scene allows") {
  const std::string touching =
      "[[spheres]]\nposition = [0.25, 0.5, 0.5]\nradius = 0.25\n[[spheres]]\nposition = [0.75, 0.5, "
      "0.5]\nradius = 0.25\n";
  CHECK(parse_scene(touching, "a.toml").bodies.size() == 2);
  const std::string pressed =
      "[[spheres]]\nposition = [0.24, 0.5, 0.5]\nradius = 0.25\n[[spheres]]\nposition = [0.7, 0.5, "
      "0.5]\nradius = 0.25\n";
  CHECK_THROWS_AS(parse_scene(pressed, "a.toml"), UserError);
  CHECK(parse_scene("[physics]\ninitial_overlap = 0.2\n" + pressed, "a.toml").bodies.size() == 2);
}

TEST_CASE("overlaps across the edge of a periodic domain are found") {
  const std::string pair =
      "[[spheres]]\nposition = [0.05, 0.5, 0.5]\nradius = 0.1\n[[spheres]]\nposition = [0.95, 0.5, "
      "0.5]\nradius = 0.1\n";
  CHECK_THROWS_WITH(parse_scene("[domain]\nboundary = 'periodic'\n" + pair, "a.toml"), Catch::Contains("spheres 0"));
}

TEST_CASE("a centre on the upper edge of a periodic domain is the same point on the lower") {
  const Scene scene = parse_scene(
      "[domain]\nboundary = 'periodic'\n[[spheres]]\nposition = [1, 0.99999999999, 0.5]\nradius = 0.1", "a.toml");
  CHECK(scene.bodies.position[0] == Vec3d(0, 0, 0.5));
}

TEST_CASE("a count from the command line replaces that of the fill, and scales several") {
  SceneOverrides overrides;
  overrides.count = 7;
  CHECK(parse_scene("[[fill]]\ncount = 100\nradius = 0.01", "a.toml", {}, overrides).bodies.size() == 7);
  const std::string two = "[[fill]]\ncount = 300\nradius = 0.02\n[[fill]]\ncount = 700\nradius = 0.01";
  overrides.count = 100;
  const Scene scene = parse_scene(two, "a.toml", {}, overrides);
  CHECK(scene.bodies.size() == 100);
  CHECK(std::count(scene.bodies.radius.begin(), scene.bodies.radius.end(), 0.02) == 30);
  for (int64_t count : {0, 1, 2, 3, 999}) {
    overrides.count = count;
    CHECK(parse_scene(two, "a.toml", {}, overrides).bodies.size() == count);
  }
}

TEST_CASE("seed and count may stand among the defaults; the command line goes first") {
  const std::string text = "[[fill]]\ncount = 5\nradius = 0.01\n[defaults]\nseed = 9\ncount = 3";
  CHECK(parse_scene(text, "a.toml").seed == 9);
  CHECK(parse_scene(text, "a.toml").bodies.size() == 3);
  SceneOverrides overrides;
  overrides.seed = 4;
  overrides.count = 2;
  CHECK(parse_scene(text, "a.toml", {}, overrides).seed == 4);
  CHECK(parse_scene(text, "a.toml", {}, overrides).bodies.size() == 2);
}

TEST_CASE("spheres come from a CSV file beside the scene, and errors name its lines") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "ballpit-scene-csv-test";
  std::filesystem::create_directories(folder);
  write_file(folder / "s.toml", "spheres = 'balls.csv'\n[[fill]]\ncount = 10\nradius = 0.05\n");
  write_file(folder / "balls.csv", "x,y,z,radius\n0.5,0.5,0.5,0.1\n0.2,0.2,0.2,0.1\n");
  const Scene scene = read_scene(folder / "s.toml");
  CHECK(scene.name == "s");
  CHECK(scene.bodies.size() == 12);
  CHECK(scene.bodies.position[1] == Vec3d(0.2, 0.2, 0.2));
  write_file(folder / "balls.csv", "x,y,z,radius\n0.5,0.5,0.5,0.1\n0.5,0.5,0.6,0.1\n");
  CHECK_THROWS_WITH(read_scene(folder / "s.toml"), Catch::Contains("balls.csv:3: x: found spheres 0 (line 2) and 1"));
  write_file(folder / "balls.csv", "x,y,z,radius\n0.5,0.5,0.5,0.1\n0.5,1.5,0.6,0.1\n");
  CHECK_THROWS_WITH(read_scene(folder / "s.toml"), Catch::Contains("balls.csv:3: y: found sphere 1 reaching from 1.4"));
  std::filesystem::remove_all(folder);
}
