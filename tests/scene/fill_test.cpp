// SPDX-License-Identifier: MIT
// Checks all pairs of filled scenes, also in float, and compares the bits with stored hashes.
#include "scene/fill.h"

#include <bit>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "scene/read_scene.h"

using namespace ballpit;

namespace {

/// Through memory, since g++ 12 removes the casts double → float → double when it vectorises them.
double as_float(double value) {
  const volatile float rounded = static_cast<float>(value);
  return static_cast<double>(rounded);
}

Vec3d as_float(const Vec3d& v) { return {as_float(v.x), as_float(v.y), as_float(v.z)}; }

Scene filled(const std::string& text, uint64_t seed = 1) {
  SceneOverrides overrides;
  overrides.seed = seed;
  return parse_scene(text, "a.toml", {}, overrides);
}

/// The smallest distance between two surfaces, as a fraction of the sum of radii, over all pairs. Positions
/// and radii are rounded to float first, as a simulation in single precision would.
double smallest_gap(const Scene& scene) {
  const Bodies& bodies = scene.bodies;
  const Vec3d edge = scene.domain.max - scene.domain.min;
  double smallest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      Vec3d d = as_float(bodies.position[i]) - as_float(bodies.position[j]);
      for (int axis = 0; axis < scene.domain.dimensions; ++axis) {
        if (scene.domain.boundary == Boundary::periodic) d[axis] -= edge[axis] * std::round(d[axis] / edge[axis]);
      }
      const double radii = as_float(bodies.radius[i]) + as_float(bodies.radius[j]);
      smallest = std::min(smallest, length(d) / radii - 1.0);
    }
  }
  return smallest;
}

bool all_inside(const Scene& scene, const Vec3d& low, const Vec3d& high, int first = 0) {
  for (size_t i = static_cast<size_t>(first); i < scene.bodies.position.size(); ++i) {
    const auto r = static_cast<float>(scene.bodies.radius[i]);
    for (int axis = 0; axis < scene.domain.dimensions; ++axis) {
      const auto x = static_cast<float>(scene.bodies.position[i][axis]);
      if (x - r < static_cast<float>(low[axis]) || x + r > static_cast<float>(high[axis])) return false;
    }
  }
  return true;
}

uint64_t hash_of(const Bodies& bodies) {
  uint64_t hash = 14695981039346656037u;  // FNV-1a, a word at a time
  const auto add = [&](double value) { hash = (hash ^ std::bit_cast<uint64_t>(value)) * 1099511628211u; };
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      add(bodies.position[i][axis]);
      add(bodies.velocity[i][axis]);
    }
    add(bodies.radius[i]);
    add(bodies.mass[i]);
  }
  return hash;
}

const std::string kPlane = "[domain]\ndimensions = 2\n";
const std::string kPeriodic = "[domain]\nboundary = 'periodic'\n";
const std::string kPeriodicPlane = "[domain]\nboundary = 'periodic'\ndimensions = 2\n";
const std::string kFarAway = "[domain]\nmin = [1000.1, -2000.3, 500]\nmax = [1001.1, -1999.3, 501]\n";

}  // namespace

TEST_CASE("randomly placed spheres never overlap and lie inside") {
  const std::vector<std::string> scenes = {
      "[[fill]]\ncount = 300\nradius = 0.05\nspeed = 1",
      "[[fill]]\ncount = 300\nradius = [0.02, 0.06]",
      "[[fill]]\ncount = 400\nradius = [0.0008, 0.08]",
      "[[fill]]\ncount = 300\nradius = 0.003\n[[fill]]\ncount = 100\nradius = [0.05, 0.08]",
      kFarAway + "[[fill]]\ncount = 200\nradius = [0.02, 0.06]",
      kPlane + "[[fill]]\ncount = 200\nradius = 0.02",
      kPlane + "[[fill]]\ncount = 400\nradius = [0.0003, 0.03]",
  };
  for (const std::string& text : scenes) {
    for (uint64_t seed = 1; seed <= 20; ++seed) {
      CAPTURE(text, seed);
      const Scene scene = filled(text, seed);
      CHECK(smallest_gap(scene) > 0.0);
      CHECK(all_inside(scene, scene.domain.min, scene.domain.max));
    }
  }
}

TEST_CASE("spheres placed in a periodic domain do not overlap across its edges, and use the edges") {
  for (const std::string& text : {kPeriodic + "[[fill]]\ncount = 300\nradius = [0.01, 0.07]",
                                  kPeriodicPlane + "[[fill]]\ncount = 300\nradius = [0.005, 0.04]"}) {
    int across = 0;
    for (uint64_t seed = 1; seed <= 20; ++seed) {
      CAPTURE(text, seed);
      const Scene scene = filled(text, seed);
      CHECK(smallest_gap(scene) > 0.0);
      across += !all_inside(scene, scene.domain.min, scene.domain.max);
      for (const Vec3d& p : scene.bodies.position) {
        CHECK((p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0 && p.z >= 0.0 && p.z < 1.0));
      }
    }
    CHECK(across == 20);
  }
}

TEST_CASE("a region holds its spheres, also above an open top") {
  const Scene scene = filled(
      "[domain]\nboundary = 'open-top'\n[[fill]]\ncount = 200\nradius = 0.03\n"
      "min = [0.5, 0.9, 0]\nmax = [1, 3, 0.5]");
  CHECK(all_inside(scene, {0.5, 0.9, 0.0}, {1.0, 3.0, 0.5}));
  CHECK(smallest_gap(scene) > 0.0);
  const Scene edge = filled(kPeriodic + "[[fill]]\ncount = 200\nradius = 0.02\nmin = [0, 0, 0]\nmax = [1, 0.3, 1]");
  for (const Vec3d& p : edge.bodies.position) CHECK((p.y >= 0.02 && p.y <= 0.28));
}

TEST_CASE("generated spheres do not overlap listed ones, and are in the order of the file") {
  const Scene scene = filled(
      "[[spheres]]\nposition = [0.5, 0.5, 0.5]\nradius = 0.4\n"
      "[[fill]]\ncount = 50\nradius = 0.02\n[[fill]]\ncount = 30\nradius = 0.04\n"
      "[[fill]]\ncount = 100\nradius = 0.03\narrangement = 'lattice'");
  CHECK(scene.bodies.radius[0] == 0.4);
  CHECK(scene.bodies.radius[50] == 0.02);
  CHECK(scene.bodies.radius[51] == 0.04);
  CHECK(scene.bodies.radius[81] == 0.03);
  CHECK(smallest_gap(scene) > 0.0);
}

TEST_CASE("a lattice is tight, starts on the floor and never overlaps in float") {
  for (const std::string& text :
       {std::string("[[fill]]\ncount = 729\nradius = 0.0555\n"), kPeriodic + "[[fill]]\ncount = 729\nradius = 0.0555\n",
        kFarAway + "[[fill]]\ncount = 729\nradius = 0.0554\n", kPlane + "[[fill]]\ncount = 361\nradius = 0.0263\n"}) {
    const Scene scene = filled(text + "arrangement = 'lattice'");
    CAPTURE(text);
    CHECK(smallest_gap(scene) > 0.0);
    CHECK(smallest_gap(scene) < 0.01);
    if (scene.domain.boundary == Boundary::walls) CHECK(all_inside(scene, scene.domain.min, scene.domain.max));
  }
  const Scene half = filled("[[fill]]\ncount = 100\nradius = 0.05\narrangement = 'lattice'");
  for (const Vec3d& p : half.bodies.position) CHECK(p.y < 0.2);
}

TEST_CASE("a lattice with a range of radii does not overlap") {
  CHECK(smallest_gap(filled("[[fill]]\ncount = 200\nradius = [0.01, 0.06]\narrangement = 'lattice'")) > 0.0);
}

TEST_CASE("radii fill their range, speeds are as given, in all directions") {
  const Scene scene = filled("[[fill]]\ncount = 4000\nradius = [0.005, 0.015]\nspeed = 2");
  double sum = 0.0;
  Vec3d drift(0.0);
  for (size_t i = 0; i < scene.bodies.radius.size(); ++i) {
    CHECK((scene.bodies.radius[i] >= 0.005 && scene.bodies.radius[i] <= 0.015));
    CHECK(length(scene.bodies.velocity[i]) == Approx(2.0));
    sum += scene.bodies.radius[i];
    drift += scene.bodies.velocity[i];
  }
  CHECK(sum / 4000.0 == Approx(0.01).margin(0.0002));
  CHECK(length(drift) / 4000.0 < 0.1);
  for (const Vec3d& v : filled(kPlane + "[[fill]]\ncount = 100\nradius = 0.01\nspeed = 2").bodies.velocity) {
    CHECK(v.z == 0.0);
    CHECK(length(v) == Approx(2.0));
  }
  const Scene same = filled("[[fill]]\ncount = 3\nradius = 0.01\nvelocity = [1, 2, 3]\nmass = 5");
  CHECK(same.bodies.velocity[2] == Vec3d(1, 2, 3));
  CHECK(same.bodies.mass[2] == 5.0);
}

TEST_CASE("generated positions are exact in float") {
  for (const Vec3d& p : filled("[[fill]]\ncount = 100\nradius = [0.01, 0.02]").bodies.position) {
    CHECK(as_float(p) == p);
  }
}

TEST_CASE("the same seed gives the same bits everywhere, another seed others") {
  const std::string text =
      "[[fill]]\ncount = 500\nradius = [0.005, 0.05]\nspeed = 1\n[[fill]]\ncount = 200\nradius = 0.03\n";
  CHECK(hash_of(filled(text, 1).bodies) == hash_of(filled(text, 1).bodies));
  CHECK(hash_of(filled(text, 1).bodies) != hash_of(filled(text, 2).bodies));
  CHECK(hash_of(filled(text, 1).bodies) == 0xE85955FED853D0DBu);
  CHECK(hash_of(filled(text, 0xFFFFFFFFFFFFFFFFu).bodies) == 0x2C7DC1D5A9B12B4Fu);
  CHECK(hash_of(filled(kPeriodicPlane + "[[fill]]\ncount = 300\nradius = [0.005, 0.04]\nspeed = 1", 1).bodies) ==
        0x74194B4817B64399u);
}

TEST_CASE("a fill that does not fit stops in bounded time, and gives the number of placed spheres") {
  CHECK_THROWS_WITH(filled("[[fill]]\ncount = 999\nradius = 0.05"),
                    Catch::Contains("999 spheres, but only 5") && Catch::Contains("52.3 %"));
  CHECK_THROWS_WITH(filled("[[fill]]\ncount = 100000000\nradius = [1e-6, 0.01]"), Catch::Contains("random placement"));
}

TEST_CASE("spheres are placed from large to small, so that wide ranges fit") {
  CHECK(filled("[[fill]]\ncount = 3000\nradius = 0.01\n[[fill]]\ncount = 1\nradius = 0.35").bodies.size() == 3001);
}

namespace {

std::string error_of(const std::string& text) {
  try {
    filled(text);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

/// The number after these words.
std::string number_behind(const std::string& text, const std::string& words) {
  const size_t begin = text.find(words) + words.size();
  std::string number = text.substr(begin, text.find_first_not_of("0123456789.e-", begin) - begin);
  while (!number.empty() && number.back() == '.') number.pop_back();
  return number;
}

}  // namespace

TEST_CASE("a scene that follows the hints of a failed fill is valid") {
  struct Crowded {
    std::string before;  ///< the fill
    int count;
    std::string radius;
    std::string arrangement;
    std::string behind{};
  };
  const std::string obstacle = "[[spheres]]\nposition = [0.5, 0.5, 0.5]\nradius = 0.45\n";
  const std::string plane = "[domain]\nmin = [0.7, 0.7, 0]\nmax = [1.7, 1.7, 0]\ndimensions = 2\n";
  const std::string far = "[domain]\nmin = [100.7, 100.7, 100.7]\nmax = [101.7, 101.7, 101.7]\n";
  const std::string periodic = "[domain]\nboundary = 'periodic'\n";
  const std::vector<Crowded> table = {
      {"", 1000, "0.1", "random"},
      {"", 1000, "0.1", "lattice"},
      {"", 100, "0.1", "random"},
      {"", 126, "0.1", "random"},
      {"", 125, "0.0999", "random"},
      {plane, 2000, "0.01", "random"},
      {plane, 3000, "0.01", "random"},
      {plane, 3000, "0.01", "lattice"},
      {far, 1, "0.5", "random"},
      {far, 1, "0.7", "lattice"},
      {"", 1, "0.5", "lattice"},
      {plane, 1, "0.5", "random"},
      {obstacle, 60, "0.1", "random"},
      {obstacle, 120, "0.1", "lattice"},
      {obstacle, 200, "0.1", "lattice"},
      {periodic, 200, "0.1", "random"},
      {periodic, 200, "0.1", "lattice"},
      {obstacle, 1, "0.3", "random"},
      {"", 100, "[0.05, 0.1]", "lattice"},
      {"", 300, "[0.05, 0.1]", "random"},
      {"", 90, "0.1", "random", "[[fill]]\ncount = 60\nradius = 0.1\narrangement = 'lattice'\n"},
  };
  for (const Crowded& crowded : table) {
    const auto scene = [&](const std::string& count, const std::string& radius, const std::string& arrangement) {
      return crowded.before + "[[fill]]\ncount = " + count + "\nradius = " + radius + "\narrangement = '" +
             arrangement + "'\n" + crowded.behind;
    };
    const std::string count = std::to_string(crowded.count);
    const std::string error = error_of(scene(count, crowded.radius, crowded.arrangement));
    INFO(scene(count, crowded.radius, crowded.arrangement) << error);
    REQUIRE(error != "");
    if (error.find("arrangement = \"lattice\"") != std::string::npos) {
      CHECK(error_of(scene(count, crowded.radius, "lattice")) == "");
    }
    if (error.find("no more fit on the lattice") != std::string::npos) {
      CHECK(error_of(scene(number_behind(error, "allowed at most "), crowded.radius, "lattice")) == "");
    }
    if (error.find("half the region") != std::string::npos) {
      CHECK(error_of(scene(count, number_behind(error, "allowed at most "), crowded.arrangement)) == "");
    }
    if (error.find("fewer") != std::string::npos) CHECK(error_of(scene("1", "0.001", crowded.arrangement)) == "");
  }
}

TEST_CASE("the message suggests a lattice only if it has room") {
  using Catch::Contains;
  const std::string offer = "arrangement = \"lattice\"";
  CHECK_THAT(error_of("[[fill]]\ncount = 100\nradius = 0.0999\n"), Contains(offer));  // 125 sites
  CHECK_THAT(error_of("[[fill]]\ncount = 100\nradius = 0.1\n"), !Contains(offer));    // 64
  CHECK_THAT(error_of("[[fill]]\ncount = 1000\nradius = 0.1\n"), !Contains(offer) && Contains("a larger region"));
}
