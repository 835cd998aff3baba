// SPDX-License-Identifier: MIT
#include "scene/read_scene.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "core/file.h"

using namespace ballpit;

TEST_CASE("every value of a scene file is read") {
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

TEST_CASE("defaults are kept as typed, with their place") {
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
  CHECK(scene.bodies.position[0] == Vec3d(0, 0.99999999999, 0.5));  // differs from 1 in double precision
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

TEST_CASE("seed and count may be defaults, the command line overrides them") {
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

TEST_CASE("integers may be written as floats") {
  const Scene scene = parse_scene(
      "[domain]\ndimensions = 2.0\n[[fill]]\ncount = 10.0\nradius = 0.01\n[defaults]\nseed = 1e3\nthreads = 1e2\n",
      "a.toml");
  CHECK(scene.domain.dimensions == 2);
  CHECK(scene.bodies.size() == 10);
  CHECK(scene.seed == 1000);
  for (const DefaultOption& option : scene.defaults) CHECK(option.value == (option.key == "seed" ? "1000" : "100"));
}

namespace {

std::vector<std::string> notes_of(const std::string& text) { return parse_scene(text, "a.toml").notes; }

std::string periodic(const std::string& min, const std::string& max) {
  return "[domain]\nboundary = 'periodic'\nmin = " + min + "\nmax = " + max + "\n";
}

std::string sphere_at(const std::string& position, const std::string& radius) {
  return "[[spheres]]\nposition = " + position + "\nradius = " + radius + "\n";
}

}  // namespace

TEST_CASE("a note reports what a scene lacks") {
  const std::string ball = sphere_at("[0.5, 0.5, 0.5]", "0.1");
  const std::string domain = "[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n";
  const std::string no_domain =
      "a.toml: found no [domain]: it is a cube of 1 m with walls, from 0 to 1 along each axis";
  const std::string no_spheres = "a.toml: found no spheres, neither [[spheres]] nor [[fill]]";
  using Notes = std::vector<std::string>;
  CHECK(notes_of("") == Notes{no_domain, no_spheres});
  CHECK(notes_of(ball) == Notes{no_domain});
  CHECK(notes_of(domain) == Notes{no_spheres});
  CHECK(notes_of(domain + ball).empty());
  CHECK(notes_of("[domain]\nboundary = 'walls'\n" + ball).empty());  // README names the defaults of min and max
}

TEST_CASE("spheres outside of a periodic domain move to their images inside, and one note reports them") {
  const std::string domain = periodic("[0, 0, 0]", "[10, 10, 10]");
  const Scene scene = parse_scene(domain + sphere_at("[-1e-9, 5, 5]", "0.5") + sphere_at("[25, -1, 10]", "0.5") +
                                      sphere_at("[2, 2, 2]", "0.5") + sphere_at("[1, 1, 1e6]", "0.5"),
                                  "a.toml");
  CHECK(scene.bodies.position[0] == Vec3d(9.999999999, 5, 5));
  CHECK(scene.bodies.position[1] == Vec3d(5, 9, 0));
  CHECK(scene.bodies.position[2] == Vec3d(2, 2, 2));
  CHECK(scene.bodies.position[3] == Vec3d(1, 1, 0));
  CHECK(scene.notes ==
        std::vector<std::string>{
            "a.toml: 3 of 4 spheres were outside of the periodic domain, and are at their images inside"});
  // The upper edge equals the lower one, so no sphere was outside.
  CHECK(notes_of(domain + sphere_at("[10, 10, 5]", "0.5")).empty());
  // So close below the edge that its image is rounded to the other edge.
  const Scene hair = parse_scene(domain + sphere_at("[-1e-20, 5, 5]", "0.5"), "a.toml");
  CHECK(hair.bodies.position[0].x >= 0);
  CHECK(hair.bodies.position[0].x < 10);
}

TEST_CASE("spheres that overlap across the edge, once wrapped, are refused") {
  CHECK_THROWS_AS(parse_scene(periodic("[0, 0, 0]", "[10, 10, 10]") + sphere_at("[0.2, 5, 5]", "0.5") +
                                  sphere_at("[-0.2, 5, 5]", "0.5"),
                              "a.toml"),
                  UserError);
}

TEST_CASE("a state of a periodic domain in single precision reads back bit-identical") {
  // The float next to 0.7 is below it.
  const double low = static_cast<double>(0.7f);
  REQUIRE(low < 0.7);
  const Scene scene = parse_scene(
      periodic("[0.7, 0.7, 0.7]", "[1.7, 1.7, 1.7]") + sphere_at("[0.699999988079071, 0.8, 0.8]", "0.05"), "a.toml");
  CHECK(scene.bodies.position[0].x == low);
  CHECK(scene.notes.empty());
  // Double precision keeps a position that single precision would round to the edge.
  const Scene fine =
      parse_scene(periodic("[0, 0, 0]", "[1, 1, 1]") + sphere_at("[0.999999999, 0.5, 0.5]", "0.05"), "a.toml");
  CHECK(fine.bodies.position[0].x == 0.999999999);
}

TEST_CASE("an edge of exactly four radii is allowed in spite of rounding") {
  CHECK_NOTHROW(
      parse_scene(periodic("[0.1, 0.1, 0.1]", "[0.3, 0.3, 0.3]") + sphere_at("[0.2, 0.2, 0.2]", "0.05"), "a.toml"));
  CHECK_NOTHROW(
      parse_scene(periodic("[100.1, 0, 0]", "[100.3, 1, 1]") + sphere_at("[100.2, 0.2, 0.2]", "0.05"), "a.toml"));
  CHECK_THROWS_AS(
      parse_scene(periodic("[0.1, 0.1, 0.1]", "[0.3, 0.3, 0.29999]") + sphere_at("[0.2, 0.2, 0.2]", "0.05"), "a.toml"),
      UserError);
}

TEST_CASE("initial_overlap = 1 allows every overlap, also of concentric spheres and of small ones in large ones") {
  const std::string domain = "[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n[physics]\ninitial_overlap = ";
  const std::string spheres = sphere_at("[0.5, 0.5, 0.5]", "0.4") + sphere_at("[0.5, 0.5, 0.5]", "0.4") +
                              sphere_at("[0.6, 0.5, 0.5]", "0.01") + sphere_at("[0, 0.5, 0.5]", "0.1");
  CHECK(parse_scene(domain + "1\n" + spheres, "a.toml").bodies.size() == 4);
  CHECK_THROWS_AS(parse_scene(domain + "0.99\n" + spheres, "a.toml"), UserError);
}

TEST_CASE("spheres that touch within single precision do not overlap") {
  // Far from the origin, rounding moves touching spheres and walls by 8e-6 m.
  const std::string domain = "[domain]\nmin = [100.7, 0, 0]\nmax = [101.7, 1, 1]\n";
  const std::string touching =
      sphere_at("[100.70999908447266, 0.5, 0.5]", "0.01") + sphere_at("[100.72999572753906, 0.5, 0.5]", "0.01");
  CHECK_NOTHROW(parse_scene(domain + touching, "a.toml"));
  CHECK_THROWS_AS(parse_scene(domain + touching + sphere_at("[100.7496, 0.5, 0.5]", "0.01"), "a.toml"), UserError);
}
