// SPDX-License-Identifier: MIT
// Every broad phase finds the contacts that brute force finds, each once, in canonical order.
#include <algorithm>

#include <catch2/catch.hpp>

#include "simulate/broadphase/grid.h"
#include "simulate/methods.h"
#include "tests/simulate/scenes.h"

using namespace ballpit;

namespace {

/// The oracle: all pairs, tested in the simulation's own precision, written independently of it.
std::vector<Pair> pairs_by_definition(const Scene& scene) {
  std::vector<Pair> pairs;
  const int n = static_cast<int>(scene.bodies.size());
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      float squared = 0.0f;
      for (int axis = 0; axis < scene.domain.dimensions; ++axis) {
        float d = float(scene.bodies.position[j][axis]) - float(scene.bodies.position[i][axis]);
        const float period = float(scene.domain.max[axis]) - float(scene.domain.min[axis]);
        if (scene.domain.boundary == Boundary::periodic) d -= period * std::round(d / period);
        squared += d * d;
      }
      const float radii = float(scene.bodies.radius[i]) + float(scene.bodies.radius[j]);
      if (squared <= radii * radii) pairs.push_back({i, j});
    }
  }
  return pairs;
}

std::vector<Pair> pairs_of(const Scene& scene, const std::string& broadphase, double cell_size = 0, int threads = 2) {
  Settings settings;
  settings.broadphase = broadphase;
  settings.threads = threads;
  if (cell_size > 0) settings.cell_size = cell_size;
  return make_cpu_world(scene, settings)->inspect().contacts;
}

struct Input {
  std::string name;
  Cloud cloud;
};

const std::vector<Input>& families() {
  static const std::vector<Input> all = [] {
    std::vector<Input> list{
        {"sparse", {.count = 400, .smallest = 0.04, .largest = 0.04}},
        {"dense", {.count = 400, .smallest = 0.12, .largest = 0.12}},
        {"clustered", {.count = 300, .smallest = 0.03, .largest = 0.03, .clusters = 4}},
        {"polydisperse", {.count = 300, .smallest = 0.01, .largest = 0.2}},
        {"negative and far from the origin",
         {.count = 300, .low = -107.0, .high = -105.0, .smallest = 0.1, .largest = 0.1}},
        {"on cell borders", {.count = 300, .smallest = 0.125, .largest = 0.125, .snap = 0.25}},
        {"touching exactly", {.count = 300, .smallest = 0.0625, .largest = 0.0625, .snap = 0.125}},
        {"all in one cell", {.count = 100, .smallest = 1.5, .largest = 1.5}},
        {"periodic", {.count = 300, .smallest = 0.1, .largest = 0.1, .boundary = Boundary::periodic}},
        {"periodic, three cells", {.count = 200, .smallest = 0.33, .largest = 0.33, .boundary = Boundary::periodic}},
        {"periodic, two cells", {.count = 100, .smallest = 0.45, .largest = 0.45, .boundary = Boundary::periodic}},
        {"periodic, one cell", {.count = 50, .smallest = 0.5, .largest = 0.5, .boundary = Boundary::periodic}},
        {"open top", {.count = 300, .smallest = 0.1, .largest = 0.1, .boundary = Boundary::open_top}},
    };
    const size_t spatial = list.size();
    for (size_t k = 0; k < spatial; ++k) {
      Input planar = list[k];
      planar.name += ", planar";
      planar.cloud.dimensions = 2;
      list.push_back(planar);
    }
    return list;
  }();
  return all;
}

}  // namespace

TEST_CASE("every broad phase finds every contact once, in order, on every family") {
  for (const Input& family : families()) {
    for (uint64_t seed = 1; seed <= 8; ++seed) {
      const Scene scene = make_cloud(family.cloud, seed);
      const std::vector<Pair> expected = pairs_by_definition(scene);
      for (const std::string_view method : method_names(Family::broadphase)) {
        INFO(family.name << ", seed " << seed << ", " << method << ", " << expected.size() << " contacts");
        REQUIRE(pairs_of(scene, std::string(method)) == expected);
      }
    }
  }
}

TEST_CASE("the families hold contacts, so that missing them would show") {
  for (const Input& family : families()) {
    INFO(family.name);
    CHECK(pairs_by_definition(make_cloud(family.cloud, 1)).size() > 5);
  }
}

TEST_CASE("linked cells find every contact when cells are one to four diameters wide") {
  for (const Input& family : families()) {
    for (const double cell_size : {1.0, 1.1, 1.5, 2.0, 3.0, 4.0}) {
      for (uint64_t seed = 20; seed < 23; ++seed) {
        const Scene scene = make_cloud(family.cloud, seed);
        INFO(family.name << ", cell size " << cell_size << ", seed " << seed);
        REQUIRE(pairs_of(scene, "linked-cell", cell_size) == pairs_by_definition(scene));
      }
    }
  }
}

TEST_CASE("cells of half a diameter miss contacts: slide 7's bound is not enough") {
  // Two equal spheres at a distance d along x, random offset: with edge c, the pair is missed where two borders lie
  // between the centres. Here c = r, d = 1.9 r: missed in most places.
  int missed = 0;
  Random random(3);
  for (int k = 0; k < 100; ++k) {
    Scene scene;
    scene.domain = {Vec3d(0.0), Vec3d(4.0), Boundary::walls, 3};
    const double x = random.uniform(0.5, 2.0);
    add_sphere(scene, {x, 1, 1}, Vec3d(0.0), 0.5);
    add_sphere(scene, {x + 0.95, 1, 1}, Vec3d(0.0), 0.5);
    REQUIRE(pairs_of(scene, "linked-cell", 1.0).size() == 1);
    missed += pairs_of(scene, "linked-cell", 0.5).empty();
  }
  // Probability that floor(x/c + 1.9) − floor(x/c) is 2: 0.9.
  CHECK(missed > 75);
  CHECK(missed < 100);
}

TEST_CASE("contacts do not depend on the number of threads") {
  const Scene scene = make_cloud({.count = 4000, .smallest = 0.05, .largest = 0.05}, 9);
  const std::vector<Pair> expected = pairs_by_definition(scene);
  REQUIRE(expected.size() > 1000);
  for (const int threads : {1, 2, 8}) {
    for (int repeat = 0; repeat < 5; ++repeat) CHECK(pairs_of(scene, "linked-cell", 0, threads) == expected);
  }
}

TEST_CASE("worlds of zero, one and two spheres are searched") {
  for (const std::string_view method : method_names(Family::broadphase)) {
    for (const int dimensions : {2, 3}) {
      Scene scene;
      scene.domain.dimensions = dimensions;
      CHECK(pairs_of(scene, std::string(method)).empty());
      add_sphere(scene, {0.5, 0.5, 0.5});
      CHECK(pairs_of(scene, std::string(method)).empty());
      add_sphere(scene, {0.5, 0.59, 0.5});
      CHECK(pairs_of(scene, std::string(method)) == std::vector<Pair>{{0, 1}});
    }
  }
}

TEST_CASE("each body is in the list of its own cell, and in no other") {
  const Scene scene = make_cloud({.count = 500, .smallest = 0.05, .largest = 0.05}, 4);
  const Inspection seen = make_cpu_world(scene)->inspect();
  REQUIRE(seen.grid);
  const GridInspection& grid = *seen.grid;
  std::vector<int> times(500, 0);
  for (int z = 0; z < grid.cells.z; ++z) {
    for (int y = 0; y < grid.cells.y; ++y) {
      for (int x = 0; x < grid.cells.x; ++x) {
        const Vec3 low = grid.origin + Vec3(x, y, z) * grid.edge;
        for (int i = grid.head[(z * grid.cells.y + y) * grid.cells.x + x]; i != -1; i = grid.next[i]) {
          ++times[i];
          for (int axis = 0; axis < 3; ++axis) {
            CHECK(seen.bodies.position_of(i)[axis] >= Approx(low[axis]).margin(1e-5));
            CHECK(seen.bodies.position_of(i)[axis] <= Approx(low[axis] + grid.edge[axis]).margin(1e-5));
          }
        }
      }
    }
  }
  CHECK(std::count(times.begin(), times.end(), 1) == 500);
}

TEST_CASE("slide 9: the point (1.5, 1.5) lies in cell 6 of a grid five cells wide") {
  Grid<Vec2> grid;
  grid.edge = grid.inverse_edge = Vec2(1.0f);
  grid.cells = {5, 5, 1};
  CHECK(grid.index(grid.cell_of({1.5f, 1.5f})) == 6);
}

TEST_CASE("candidates are counted: all pairs by brute force, fewer by cells") {
  const Scene scene = make_cloud({.count = 500, .smallest = 0.05, .largest = 0.05}, 4);
  const auto candidates = [&](const char* method) {
    Settings settings;
    settings.broadphase = method;
    return make_cpu_world(scene, settings)->report().candidates;
  };
  CHECK(candidates("brute-force") == 500 * 499 / 2);
  CHECK(candidates("linked-cell") < 500 * 499 / 2 / 20);
}

TEST_CASE("a few spheres in a vast domain need few cells") {
  Scene scene;
  scene.domain.max = Vec3d(1000.0);
  add_sphere(scene, Vec3d(1.0), Vec3d(0.0), 0.01);
  add_sphere(scene, Vec3d(1.015, 1.0, 1.0), Vec3d(0.0), 0.01);
  const Inspection seen = make_cpu_world(scene)->inspect();
  CHECK(seen.grid->head.size() < 10000);
  CHECK(seen.contacts.size() == 1);
}

TEST_CASE("a cell size that needs more cells than an index holds is refused with the number") {
  Scene scene;
  scene.domain.max = Vec3d(1000.0);
  add_sphere(scene, Vec3d(1.0), Vec3d(0.0), 0.01);
  CHECK_THROWS_WITH(pairs_of(scene, "linked-cell", 1.0), Catch::Contains("--cell-size") && Catch::Contains("cells"));
}
