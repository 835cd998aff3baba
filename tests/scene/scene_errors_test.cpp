// SPDX-License-Identifier: MIT
// Errors of wrong scenes: one line with file, line, key, what was found and what is allowed.
#include <catch2/catch.hpp>

#include "core/error.h"
#include "scene/read_scene.h"

using namespace ballpit;

namespace {

struct Wrong {
  std::string text;
  std::string message;  // without the file's name
};

std::string message_of(const std::string& text, const SceneOverrides& overrides = {}) {
  try {
    parse_scene(text, "a.toml", {}, overrides);
  } catch (const UserError& error) {
    return error.what();
  }
  return "no error";
}

void check_all(const std::vector<Wrong>& table) {
  for (const Wrong& wrong : table) {
    INFO(wrong.text);
    CHECK(message_of(wrong.text) == "a.toml:" + wrong.message);
  }
}

const std::string kDomainKeys = "min, max, boundary, dimensions";
const std::string kAny = "-1e+15 to 1e+15";
const std::string kLength = "1e-12 to 1e+15";
const std::string kCount = "an integer, 0 to 100000000";

}  // namespace

TEST_CASE("unknown keys are refused at every level, with the valid ones") {
  check_all({
      {"titel = 'x'",
       "1: titel: found an unknown key, allowed title, description, title_de, description_de, domain, "
       "physics, "
       "spheres, fill, defaults, needs, view"},
      {"[domain]\nmin = [0, 0, 0]\nmaximum = [1, 1, 1]",
       "3: [domain] maximum: found an unknown key, allowed " + kDomainKeys},
      {"[physics]\n\ngravty = 1",
       "3: [physics] gravty: found an unknown key, allowed gravity, restitution, wall_restitution, "
       "stiffness, law, "
       "shear, initial_overlap, density"},
      {"[[spheres]]\nposition = [.5, .5, .5]\nr = 1",
       "2: found a syntax error: Error while parsing floating-point: expected decimal digit, saw '.', "
       "allowed TOML 1.0"},
      {"[[spheres]]\nr = 1", "2: [[spheres]] r: found an unknown key, allowed position, velocity, radius, mass"},
      {"[[fill]]\nnumber = 1",
       "2: [[fill]] number: found an unknown key, allowed count, radius, speed, velocity, min, max, "
       "arrangement, mass"},
      {"[needs]\ntime = 1",
       "2: [needs] time: found an unknown key, allowed duration, max_overlap, max_overlap_ever, "
       "energy_tolerance, momentum_tolerance, max_speed, path_tolerance, effects, observables"},
      {"[view]\nzoom = 2", "2: [view] zoom: found an unknown key, allowed min, max"},
      {"\"a\\nb\" = 1",
       "1: a\\x0Ab: found an unknown key, allowed title, description, title_de, description_de, domain, "
       "physics, "
       "spheres, fill, defaults, needs, view"},
  });
}

TEST_CASE("wrong types are refused") {
  check_all({
      {"title = 3", "1: title: found 3, allowed a text in quotes"},
      {"domain = 3", "1: domain: found 3, allowed a table [domain]"},
      {"physics = 'x'", "1: physics: found \"x\", allowed a table [physics]"},
      {"spheres = 3", "1: spheres: found 3, allowed tables [[spheres]], or the name of a CSV file"},
      {"[spheres]", "1: spheres: found a table, allowed tables [[spheres]], or the name of a CSV file"},
      {"spheres = [1]", "1: spheres: found 1, allowed tables [[spheres]]"},
      {"[fill]\ncount = 1", "1: fill: found a table, allowed tables [[fill]]"},
      {"[physics]\nrestitution = 'high'", "2: [physics] restitution: found \"high\", allowed a number, 0 to 1"},
      {"[physics]\nrestitution = true", "2: [physics] restitution: found true, allowed a number, 0 to 1"},
      {"[physics]\nrestitution = 1979-05-27",
       "2: [physics] restitution: found a date or time, allowed a number, 0 to 1"},
      {"[physics]\ngravity = 9.81", "2: [physics] gravity: found 9.81, allowed an array of 3 numbers"},
      {"[physics]\ngravity = [0,\n'x', 0]", "3: [physics] gravity[1]: found \"x\", allowed a number, " + kAny},
      {"[physics]\nlaw = 1", "2: [physics] law: found 1, allowed linear, hertz"},
      {"[[fill]]\ncount = 10.5\nradius = 0.1", "2: [[fill]] count: found 10.5, allowed " + kCount},
      {"[[fill]]\ncount = nan\nradius = 0.1", "2: [[fill]] count: found nan, allowed " + kCount},
      {"[[fill]]\ncount = 1e300\nradius = 0.1", "2: [[fill]] count: found 1e+300, allowed " + kCount},
      {"[[fill]]\ncount = '10'\nradius = 0.1", "2: [[fill]] count: found \"10\", allowed " + kCount},
      {"[[fill]]\ncount = 1\nradius = 'x'", "3: [[fill]] radius: found \"x\", allowed a number, " + kLength},
      {"[defaults]\ndt = [1]",
       "2: [defaults] dt: found an array of 1 values, allowed a number, a text in quotes, true or false"},
      {"[defaults]\nseed = 1.5", "2: [defaults] seed: found 1.5, allowed an integer, 0 to 9223372036854775807"},
  });
}

TEST_CASE("impossible values of the domain are refused") {
  check_all({
      {"[domain]\nmin = [0, 0, 0]\nmax = [1, 0, 1]", "3: [domain] max: found 0 to 0 at [1], allowed min below max"},
      {"[domain]\nmin = [0, 0, 2]", "2: [domain] min: found 2 to 1 at [2], allowed min below max"},
      {"[domain]\nmax = [1, nan, 1]", "2: [domain] max[1]: found nan, allowed " + kAny},
      {"[domain]\nmax = [1, inf, 1]", "2: [domain] max[1]: found inf, allowed " + kAny},
      {"[domain]\nmax = [1, 1]", "2: [domain] max: found an array of 2 values, allowed an array of 3 numbers"},
      {"[domain]\ndimensions = 2\nmax = [1]",
       "3: [domain] max: found an array of 1 values, allowed an array of 2 or 3 numbers"},
      {"[domain]\ndimensions = 4", "2: [domain] dimensions: found 4, allowed an integer, 2 to 3"},
      {"[domain]\ndimensions = 2.5", "2: [domain] dimensions: found 2.5, allowed an integer, 2 to 3"},
      {"[domain]\nboundary = 'wall'", "2: [domain] boundary: found \"wall\", allowed walls, open-top, periodic"},
      {"[domain]\nboundary = 'periodic'\n[[fill]]\ncount = 1\nradius = 0.3",
       "1: [domain] max: found an edge of 1 along x with radius 0.3, allowed at least four radii, 1.2, in a "
       "periodic domain"},
  });
}

TEST_CASE("impossible values of the physics and the needs are refused") {
  check_all({
      {"[physics]\nrestitution = 1.5", "2: [physics] restitution: found 1.5, allowed 0 to 1"},
      {"[physics]\nrestitution = nan", "2: [physics] restitution: found nan, allowed 0 to 1"},
      {"[physics]\nwall_restitution = -0.1", "2: [physics] wall_restitution: found -0.1, allowed 0 to 1"},
      {"[physics]\ngravity = [0, -inf, 0]", "2: [physics] gravity[1]: found -inf, allowed " + kAny},
      {"[physics]\nstiffness = 0", "2: [physics] stiffness: found 0, allowed " + kLength},
      {"[physics]\nshear = -1", "2: [physics] shear: found -1, allowed 0 to 1e+15"},
      {"[physics]\nlaw = 'hooke'", "2: [physics] law: found \"hooke\", allowed linear, hertz"},
      {"[physics]\ninitial_overlap = 2", "2: [physics] initial_overlap: found 2, allowed 0 to 1"},
      {"[physics]\ndensity = -1", "2: [physics] density: found -1, allowed " + kLength},
      {"[needs]\nduration = -1", "2: [needs] duration: found -1, allowed 0 to 1e+15"},
      {"[needs]\nmax_overlap = nan", "2: [needs] max_overlap: found nan, allowed 0 to 1e+15"},
      {"[needs]\nenergy_tolerance = -1", "2: [needs] energy_tolerance: found -1, allowed 0 to 1e+15"},
      {"[needs]\nmax_speed = inf", "2: [needs] max_speed: found inf, allowed 0 to 1e+15"},
  });
}

TEST_CASE("impossible spheres are refused") {
  const std::string half = "[[spheres]]\nposition = [0.5, 0.5, 0.5]\n";
  check_all({
      {"[[spheres]]\nradius = 1",
       "1: [[spheres]] position: found nothing, allowed the centre of the sphere, [x, y, z]"},
      {half, "1: [[spheres]] radius: found nothing, allowed " + kLength},
      {half + "radius = 0", "3: [[spheres]] radius: found 0, allowed " + kLength},
      {half + "radius = -0.1", "3: [[spheres]] radius: found -0.1, allowed " + kLength},
      {half + "radius = nan", "3: [[spheres]] radius: found nan, allowed " + kLength},
      {half + "radius = 0.1\nmass = 0", "4: [[spheres]] mass: found 0, allowed 1e-30 to 1e+30"},
      {half + "radius = 0.1\nmass = -2", "4: [[spheres]] mass: found -2, allowed 1e-30 to 1e+30"},
      {half + "radius = 0.1\nvelocity = [1, 2]",
       "4: [[spheres]] velocity: found an array of 2 values, allowed an array of 3 numbers"},
      {half + "radius = 0.1\nvelocity = [1, 2, nan]", "4: [[spheres]] velocity[2]: found nan, allowed " + kAny},
      {half + "radius = 1e12",
       "3: [[spheres]] radius: found 1e+12, which makes a mass of 4.188790204786391e+39 kg, allowed 1e-30 "
       "to 1e+30 "
       "kg"},
      {"\n[[spheres]]\nposition = [0.5, 0.95, 0.5]\nradius = 0.1",
       "3: [[spheres]] position[1]: found sphere 0 reaching from 0.85 to 1.05, allowed 0 to 1, the domain"},
      {"[domain]\nboundary = 'open-top'\n[[spheres]]\nposition = [0.5, 0.0, 0.5]\nradius = 0.25",
       "4: [[spheres]] position[1]: found sphere 0 reaching from -0.25 to 0.25, allowed above 0, the domain"},
      {half + "radius = 0.25\n[[spheres]]\nposition = [0.75, 0.5, 0.5]\nradius = 0.125",
       "5: [[spheres]] position: found spheres 0 (line 2) and 1 overlapping by 0.125 m, 1 of the smaller "
       "radius, "
       "allowed 1e-06, see [physics] initial_overlap"},
      {"spheres = 'nowhere.csv'",
       "1: spheres: found \"nowhere.csv\", but no such file, allowed a CSV file beside the scene"},
  });
}

TEST_CASE("impossible fills are refused") {
  const std::string one = "[[fill]]\ncount = 1\n";
  const std::string ball = one + "radius = 0.1\n";
  const std::string help = "allowed fewer or smaller spheres, a larger region, or arrangement = \"lattice\"";
  const std::string help_without_lattice = "allowed fewer or smaller spheres, or a larger region";
  check_all({
      {"[[fill]]\nradius = 1", "1: [[fill]] count: found nothing, allowed " + kCount},
      {one, "1: [[fill]] radius: found nothing, allowed a number, or an array of 2 numbers, low and high"},
      {"[[fill]]\ncount = -1\nradius = 1", "2: [[fill]] count: found -1, allowed " + kCount},
      {"[[fill]]\ncount = 100000001\nradius = 1", "2: [[fill]] count: found 100000001, allowed " + kCount},
      {one + "radius = 0", "3: [[fill]] radius: found 0, allowed " + kLength},
      {one + "radius = [0.2, 0.1]", "3: [[fill]] radius: found 0.2 before 0.1, allowed low before high"},
      {one + "radius = [0.2, nan]", "3: [[fill]] radius[1]: found nan, allowed " + kLength},
      {one + "radius = [0.2]",
       "3: [[fill]] radius: found an array of 1 values, allowed a number, or an array of 2 numbers, low and "
       "high"},
      {one + "radius = 0.6",
       "2: [[fill]] radius: found 0.6, allowed at most 0.4999, below half the region, whose edge along x is 1"},
      {ball + "speed = -1", "4: [[fill]] speed: found -1, allowed 0 to 1e+15"},
      {ball + "speed = 1\nvelocity = [0, 0, 0]",
       "4: [[fill]] speed: found both speed and velocity, allowed one of them"},
      {ball + "mass = 0", "4: [[fill]] mass: found 0, allowed 1e-30 to 1e+30"},
      {ball + "arrangement = 'hexagonal'", "4: [[fill]] arrangement: found \"hexagonal\", allowed random, lattice"},
      {ball + "min = [-1, 0, 0]", "4: [[fill]] min: found -1 at [0], allowed at least 0, the domain's"},
      {ball + "max = [1, 2, 1]", "4: [[fill]] max: found 2 at [1], allowed at most 1, the domain's"},
      {ball + "min = [0, 0.5, 0]\nmax = [1, 0.5, 1]",
       "5: [[fill]] max: found 0.5 to 0.5 at [1], allowed min below max"},
      {"[[fill]]\ncount = 92000000\nradius = 0.02",
       "2: [[fill]] count: found 92000000 spheres: they ask for 308295 % of their region, random placement "
       "reaches "
       "about 38 %, " +
           help_without_lattice},
      {"[[fill]]\ncount = 100\nradius = 0.1",
       "2: [[fill]] count: found 100 spheres, but only 68 found room: they ask for 41.9 % of their region, "
       "random "
       "placement reaches about 38 %, " +
           help_without_lattice},
      {"[domain]\ndimensions = 2\n[[fill]]\ncount = 2000\nradius = 0.01",
       "4: [[fill]] count: found 2000 spheres: they ask for 62.8 % of their region, random placement reaches "
       "about "
       "54 %, " +
           help},
      {"[[fill]]\ncount = 65\nradius = 0.1249\narrangement = 'lattice'",
       "2: [[fill]] count: found 65, allowed at most 64: no more fit on the lattice in this region"},
  });
}

TEST_CASE("impossible overrides are refused") {
  SceneOverrides count;
  count.count = 10;
  CHECK(message_of("title = 'x'", count) == "a.toml:1: --count: found 10, allowed only in a scene with a [[fill]]");
  count.count = -1;
  CHECK(message_of("[[fill]]\ncount = 1\nradius = 0.1", count) ==
        "a.toml:1: --count: found -1, allowed 0 to 100000000");
  count.count = 100'000;
  CHECK_THAT(message_of("\n[[fill]]\ncount = 1\nradius = 0.1", count),
             Catch::StartsWith("a.toml:3: [[fill]] count (--count): found 100000 spheres: they ask for 41887.9 %"));
  CHECK_THAT(message_of("[[fill]]\ncount = 100000000\nradius = 1e-6\n[[fill]]\ncount = 1\nradius = 1e-6"),
             Catch::StartsWith("a.toml:5: [[fill]] count: found 100000001 spheres altogether, allowed at most"));
}

TEST_CASE("a syntax error names its line") {
  CHECK_THAT(message_of("title = 'x'\n[domain\n"), Catch::StartsWith("a.toml:2: found a syntax error: "));
  CHECK_THAT(message_of("a = 1\na = 2\n"), Catch::StartsWith("a.toml:2: found a syntax error: "));
  CHECK_THAT(message_of(std::string("\xFF\xFE\0rubbish", 10)), Catch::StartsWith("a.toml:1: found a syntax error: "));
}
