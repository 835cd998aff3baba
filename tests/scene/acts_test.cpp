// SPDX-License-Identifier: MIT
// Files of acts: what is read is what was written, and each mistake is named with its line and key.
#include "scene/acts.h"

#include <fstream>

#include <catch2/catch.hpp>

#include "core/error.h"

using namespace ballpit;

namespace {

Scene box_of_two(int dimensions = 3, Boundary boundary = Boundary::walls) {
  Scene scene;
  scene.domain = {Vec3d(0.0), dimensions == 2 ? Vec3d(2, 1, 0) : Vec3d(2, 1, 1), boundary, dimensions};
  const double z = dimensions == 2 ? 0 : 0.5;
  scene.bodies = {{{0.5, 0.5, z}, {1.5, 0.5, z}}, {Vec3d(0.0), Vec3d(0.0)}, {0.1, 0.1}, {2, 2}};
  return scene;
}

/// The acts in a file with this text.
std::vector<Act> acts_in(const std::string& text, const Scene& scene) {
  const auto path = std::filesystem::temp_directory_path() / "ballpit-acts-test.toml";
  std::ofstream(path) << text;
  return read_acts(path, scene, scene.bodies);
}

std::string mistake_in(const std::string& text, const Scene& scene = box_of_two()) {
  try {
    acts_in(text, scene);
  } catch (const UserError& error) {
    const std::string what = error.what();
    return what.substr(what.find("test.toml") + 9);
  }
  return "none";
}

std::string act(const std::string& kind, const std::string& more, const std::string& time = "0.5") {
  return "[[act]]\ntime = " + time + "\nact = \"" + kind + "\"\n" + more + "\n";
}

}  // namespace

TEST_CASE("acts are read as they were written, to the bit") {
  const Scene scene = box_of_two();
  const std::vector<Act> acts{
      {.time = 0, .kind = ActKind::to_throw, .sphere = 1, .vector = {1.0 / 3, -2e-7, 0.1}},
      {.time = 1.0 / 240, .kind = ActKind::push, .sphere = 0, .vector = {0, 4, 0}, .reach = 0.3f},
      {.time = 1.0 / 240, .kind = ActKind::drop, .sphere = 2, .vector = {1, 0.8, 0.1}, .radius = 0.07, .mass = 1e-3},
      {.time = 2, .kind = ActKind::to_throw, .sphere = 2, .vector = {0, 0, 1}}};
  CHECK(acts_in(text_of(acts, 3, "# a comment\n"), scene) == acts);
  CHECK(acts_in("", scene).empty());
}

TEST_CASE("a drop without a size is like most spheres, and one with a radius has their density") {
  const std::vector<Act> acts = acts_in(
      act("drop", "vector = [1, 0.5, 0.5]") + act("drop", "vector = [1, 0.2, 0.5]\nradius = 0.05"), box_of_two());
  CHECK(acts[0].sphere == 2);
  CHECK(acts[0].radius == 0.1);
  CHECK(acts[0].mass == 2);
  CHECK(acts[1].sphere == 3);
  CHECK(acts[1].mass == Approx(0.25));
  CHECK(acts_in(act("push", "sphere = 0\nvector = [1, 0, 0]"), box_of_two())[0].reach == Approx(0.4));
}

TEST_CASE("a planar scene takes two numbers") {
  CHECK(acts_in(act("throw", "sphere = 0\nvector = [1, 2]"), box_of_two(2))[0].vector == Vec3d(1, 2, 0));
  CHECK(mistake_in(act("throw", "sphere = 0\nvector = [1]"), box_of_two(2)) ==
        ":5: [[act]] vector: found an array of 1 values, allowed an array of 2 or 3 numbers");
}

TEST_CASE("each mistake in a file of acts is named with line, key, what was found and what is allowed") {
  const std::string fine = "sphere = 0\nvector = [1, 0, 0]";
  CHECK(mistake_in("[[act]\n").starts_with(":1: found a syntax error"));
  CHECK(mistake_in("[[acts]]\n") == ":1: acts: found an unknown key, allowed act");
  CHECK(mistake_in("act = 3\n") == ":1: act: found 3, allowed tables [[act]]");
  CHECK(mistake_in(act("throw", fine + "\nspin = 1")) ==
        ":6: [[act]] spin: found an unknown key, allowed time, act, sphere, vector, reach, radius, mass");
  CHECK(mistake_in(act("kick", fine)) == ":3: [[act]] act: found \"kick\", allowed throw, push, drop");
  CHECK(mistake_in("[[act]]\ntime = 1\n") == ":1: [[act]] act: found nothing, allowed throw, push, drop");
  CHECK(mistake_in("[[act]]\nact = \"throw\"\n") == ":1: [[act]] time: found nothing, allowed 0 to 1e+09");
  CHECK(mistake_in(act("throw", fine, "-1")) == ":2: [[act]] time: found -1, allowed 0 to 1e+09");
  CHECK(mistake_in(act("throw", fine, "nan")) == ":2: [[act]] time: found nan, allowed 0 to 1e+09");
  CHECK(mistake_in(act("throw", fine) + act("throw", fine, "0.4")) ==
        ":7: [[act]] time: found 0.4, allowed 0.5, the time of the act before, or more");
  CHECK(mistake_in(act("throw", "vector = [1, 0, 0]")) ==
        ":1: [[act]] sphere: found nothing, allowed an integer, 0 to 1");
  CHECK(mistake_in(act("throw", "sphere = 2\nvector = [1, 0, 0]")) ==
        ":4: [[act]] sphere: found 2, allowed an integer, 0 to 1");
  CHECK(mistake_in(act("throw", "sphere = 0")) == ":1: [[act]] vector: found nothing, allowed an array of 3 numbers");
  CHECK(mistake_in(act("throw", "sphere = 0\nvector = [1, inf, 0]")) ==
        ":5: [[act]] vector[1]: found inf, allowed -1e+15 to 1e+15");
  CHECK(mistake_in(act("throw", fine + "\nreach = 1")) ==
        ":6: [[act]] reach: found 1, allowed only with act = \"push\"");
  CHECK(mistake_in(act("push", fine + "\nmass = 1")) == ":6: [[act]] mass: found 1, allowed only with act = \"drop\"");
  CHECK(mistake_in(act("push", fine + "\nreach = -1")) == ":6: [[act]] reach: found -1, allowed 0 to 1e+15");
  CHECK(mistake_in(act("drop", "vector = [1, 1, 0.5]")) ==
        ":4: [[act]] vector: found a sphere of radius 0.1 at [1, 1, 0.5], allowed inside of the domain, [0, 0, 0] to "
        "[2, 1, 1]");
  CHECK(mistake_in(act("drop", "vector = [1, 0.5, 0.5]\nradius = 0.6")) ==
        ":5: [[act]] radius: found 0.6, allowed 1e-12 to 0.5");
  CHECK(mistake_in(act("drop", "vector = [1, 0.5, 0.5]\nsphere = 7")) ==
        ":5: [[act]] sphere: found 7, allowed an integer, 2 to 2");
}

TEST_CASE("a dropped sphere may be thrown later, but not before, an open top has no ceiling") {
  const std::string drop = act("drop", "vector = [1, 0.5, 0.5]"), toss = act("throw", "sphere = 2\nvector = [1, 0, 0]");
  CHECK(acts_in(drop + toss, box_of_two()).size() == 2);
  CHECK(mistake_in(toss + drop) == ":4: [[act]] sphere: found 2, allowed an integer, 0 to 1");
  const std::string above = act("drop", "vector = [1, 7, 0.5]");
  CHECK(mistake_in(above, box_of_two(3, Boundary::open_top)) == "none");
  CHECK(mistake_in(above) != "none");
}

TEST_CASE("where there is no sphere, only a drop is possible, with a size of the domain's") {
  Scene empty = box_of_two();
  empty.bodies = {};
  CHECK(mistake_in(act("throw", "sphere = 0\nvector = [1, 0, 0]"), empty) ==
        ":4: [[act]] sphere: found 0, allowed a drop before it: there is no sphere yet");
  const std::vector<Act> acts =
      acts_in(act("drop", "vector = [1, 0.5, 0.5]") + act("push", "sphere = 0\nvector = [1, 0, 0]"), empty);
  CHECK(acts[0].radius == Approx(0.05));
  CHECK(acts[0].mass == Approx(1000 * 4 / 3.0 * 3.14159265 * 1.25e-4));
}
