// SPDX-License-Identifier: MIT
// WrongScene scene and CSV files reach the user with status 2 and one line of file, line, key, found and allowed.
// All that can be wrong in them is tested in tests/scene; here, that it is passed on.
#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/run_program.h"

using namespace ballpit;

namespace {

struct WrongScene {
  std::string scene;
  std::string message;  ///< after the scene's or the CSV file's name
  std::string csv{};    ///< beside it, as s.csv
  std::vector<std::string> options{};
};

void check_scenes(const std::vector<WrongScene>& table) {
  const Scratch scratch;
  for (const WrongScene& wrong : table) {
    write_text(scratch / "a.toml", wrong.scene);
    write_text(scratch / "s.csv", wrong.csv);
    const Outcome outcome = run_program(with({"simulate", scratch / "a.toml", "--time", "0"}, wrong.options));
    INFO(wrong.scene << wrong.csv);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    const std::string file = wrong.csv.empty() ? "a.toml" : "s.csv";
    CHECK_THAT(outcome.err, Catch::StartsWith("ballpit: " + scratch / file + ":" + wrong.message));
  }
}

}  // namespace

TEST_CASE("errors in a scene reach the user with file, line and key") {
  check_scenes({
      {"title = 'x'\n[domain\n", "2: found a syntax error"},
      {"titel = 'x'", "1: titel: found an unknown key, allowed title"},
      {"[physics]\nrestitution = 1.5", "2: [physics] restitution: found 1.5, allowed 0 to 1"},
      {"[physics]\n\ngravity = 'down'", "3: [physics] gravity: found \"down\", allowed an array of 3 numbers"},
      {"[[spheres]]\nposition = [0.5, 0.95, 0.5]\nradius = 0.1",
       "2: [[spheres]] position[1]: found sphere 0 reaching from 0.85 to 1.05, allowed 0 to 1, the domain"},
      {"[[spheres]]\nposition = [0.5, 0.5, 0.5]\nradius = 0.1\n[[spheres]]\nposition = [0.6, 0.5, "
       "0.5]\nradius = 0.1",
       "5: [[spheres]] position: found spheres 0 (line 2) and 1 overlapping by 0.1"},
      {"[[fill]]\ncount = 100\nradius = 0.1", "2: [[fill]] count: found 100 spheres, but only "},
      {"spheres = 'nowhere.csv'", "1: spheres: found \"nowhere.csv\", but no such file"},
      {"[[fill]]\ncount = 1\nradius = 0.1",
       "2: [[fill]] count (--count): found 100000 spheres: they ask for",
       "",
       {"--count", "100000"}},
      {"title = 'x'", "1: --count: found 3, allowed only in a scene with a [[fill]]", "", {"--count", "3"}},
  });
}

TEST_CASE("options that a scene presets are checked as on the command line, with their place") {
  check_scenes({
      {"[defaults]\n\nspeed = 1", "3: [defaults] speed: found no option of this name, allowed broadphase"},
      {"[defaults]\ndt = 0", "2: [defaults] dt: found 0, allowed 1e-12 to 10"},
      {"[defaults]\ndt = nan", "2: [defaults] dt: found nan, allowed 1e-12 to 10"},
      {"[defaults]\ndt = 'fast'", "2: [defaults] dt: found fast, allowed 1e-12 to 10"},
      {"[defaults]\nbroadphase = 'magic'", "2: [defaults] broadphase: found magic, allowed auto, brute-force"},
      {"[defaults]\nresponse = 'magic'",
       "2: [defaults] response: found magic, allowed auto, kinematic, impulse, penalty"},
      {"[defaults]\nthreads = 1.5", "2: [defaults] threads: found 1.5, allowed 0 to 256"},
      {"[defaults]\nsubsteps = true", "2: [defaults] substeps: found true, allowed 1 to 1000"},
      {"[defaults]\ncell-size = -1", "2: [defaults] cell-size: found -1, allowed 0.05 to 1000"},
      {"[defaults]\nseed = -1", "2: [defaults] seed: found -1, allowed an integer"},
      {"[defaults]\ndt = [1]", "2: [defaults] dt: found an array of 1 values"},
  });
}

TEST_CASE("a preset that does not go with the scene's own response is an error that names file and line") {
  check_scenes({
      {"[defaults]\nresponse = 'impulse'\nintegrator = 'rk4'",
       "3: [defaults] integrator: found rk4, allowed symplectic-euler with --response impulse\n"},
      {"[defaults]\niterations = 5\n\nresponse = 'penalty'",
       "2: [defaults] iterations: found 5, allowed with --response impulse, position-based, not penalty\n"},
      {"[defaults]\ncontact-end = 'force'",
       "2: [defaults] contact-end: found force, allowed with --response penalty, not impulse\n"},
      {"[defaults]\nresponse = 'event-driven'\nprecision = 'float'",
       "3: [defaults] precision: found float, allowed double with --response event-driven\n"},
      // … and one that goes with no response given, where the same response is given again.
      {"[defaults]\nswept = 'on'\nresponse = 'penalty'",
       "2: [defaults] swept: found on, allowed with --response kinematic, impulse, not penalty\n",
       "",
       {"--response", "penalty"}},
  });
}

TEST_CASE("a preset that does not go with the response given is dropped, and one that does is kept") {
  const Scratch scratch;
  const std::string scene = scratch / "a.toml";
  write_text(scene,
             "[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n[[spheres]]\nposition = [0.5, 0.5, 0.5]\nradius = "
             "0.1\n[defaults]\nresponse = 'penalty'\n"
             "integrator = 'rk4'\ncontact-end = 'force'\nprecision = 'float'\ndt = 0.001\n");
  const auto methods_with = [&](const char* response) {
    const Outcome outcome = run_program({"simulate", scene, "--time", "0.002", "--response", response, "--json"});
    INFO(response << ": " << outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.err.empty());
    CHECK(outcome.json()["dt"] == 0.001);
    return outcome.json()["methods"];
  };
  CHECK(methods_with("penalty")["integrator"] == "rk4");
  CHECK(methods_with("impulse")["integrator"] == "symplectic-euler");
  CHECK(methods_with("impulse")["precision"] == "float");
  CHECK(methods_with("event-driven")["integrator"] == "exact");
  CHECK(methods_with("event-driven")["precision"] == "double");
  CHECK(methods_with("event-driven")["backend"] == "cpu");
}

TEST_CASE("errors in a CSV file reach the user with its name and line") {
  const std::string scene = "spheres = 's.csv'";
  const std::string header = "x,y,z,radius\n";
  check_scenes({
      {scene, "2: y: found \"nan\"", header + "0.5,nan,0.5,0.1\n"},
      {scene, "3: radius: found \"-0.1\"", header + "0.5,0.5,0.5,0.1\n0.5,0.5,0.5,-0.1\n"},
      {scene, "2: x: found \"abc\"", header + "abc,0.5,0.5,0.1\n"},
      {scene, "2: ", header + "0.5,0.5\n"},
      {scene, "1: ", "a,b,c\n1,2,3\n"},
      {scene, "3: x: found spheres 0 (line 2) and 1 overlapping by 0.1", header + "0.5,0.5,0.5,0.1\n0.6,0.5,0.5,0.1\n"},
  });
}
