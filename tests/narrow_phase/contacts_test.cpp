// SPDX-License-Identifier: MIT
// Every broad phase finds the contacts that follow from their definition, each once, in canonical order.
#include <algorithm>

#include <catch2/catch.hpp>

#include "measure/exact_pairs.h"
#include "methods/methods.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

std::vector<Pair> contacts_in_world(const Scene& scene, const Way& way) {
  return make_cpu_world(scene, settings_of(way))->inspect().contacts;
}

std::vector<Pair> found_pairs(const Spheres& spheres, const Way& way) {
  const auto search = cpu_backend().make_pair_search(settings_of(way));
  search->find(arrays_of(spheres));
  return search->pairs();
}

/// Spheres whose centres are on a plane are searched in it, unless the axis lies across it.
bool fits_a_plane(const Way& way) { return way.axis != "z"; }

}  // namespace

TEST_CASE("worlds find every contact once, in order, whatever the method and the spheres") {
  for (const Input& input : inputs()) {
    for (uint64_t seed = 1; seed <= 4; ++seed) {
      const Scene scene = input.make(seed);
      const std::vector<Pair> expected = pairs_by_definition(scene);
      for (const Way& way : ways(scene.domain.dimensions)) {
        INFO(input.name << ", seed " << seed << ", " << way << ", " << expected.size() << " contacts");
        REQUIRE(difference(contacts_in_world(scene, way), expected) == "");
      }
    }
  }
}

TEST_CASE("pair searches find every contact once, in order, whatever the method and the spheres") {
  for (const Input& input : inputs()) {
    for (uint64_t seed = 11; seed <= 13; ++seed) {
      Scene scene = input.make(seed);
      scene.domain.boundary = Boundary::walls;  // a pair search knows no other
      const std::vector<Pair> expected = pairs_by_definition(scene);
      Spheres spheres = spheres_of(scene);
      for (const Way& way : ways(3)) {
        INFO(input.name << ", seed " << seed << ", " << way << ", " << expected.size() << " contacts");
        REQUIRE(difference(found_pairs(spheres, way), expected) == "");
      }
      spheres.radius.resize(spheres.position.size(), spheres.radius[0]);  // equal radii need not be given as one
      INFO(input.name << ", seed " << seed << ", a radius each");
      REQUIRE(difference(found_pairs(spheres, {.broadphase = "sorted-grid"}), expected) == "");
      REQUIRE(difference(found_pairs(spheres, {.broadphase = "sort-and-sweep"}), expected) == "");
    }
  }
}

TEST_CASE("the inputs hold contacts, so that missing them would show") {
  for (const Input& input : inputs()) {
    INFO(input.name);
    CHECK(pairs_by_definition(input.make(1)).size() > 5);
  }
}

TEST_CASE("cells of one to four diameters find every contact") {
  for (const Input& input : inputs()) {
    for (uint64_t seed = 20; seed < 22; ++seed) {
      const Scene scene = input.make(seed);
      const std::vector<Pair> expected = pairs_by_definition(scene);
      for (const Way& way : ways_with_cell_sizes()) {
        INFO(input.name << ", seed " << seed << ", " << way);
        REQUIRE(difference(contacts_in_world(scene, way), expected) == "");
      }
    }
  }
}

TEST_CASE("contacts do not depend on the number of threads", "[slow]") {
  const Cloud cloud = GENERATE(Cloud{.count = 6000, .smallest = 0.05, .largest = 0.05},
                               Cloud{.count = 6000, .smallest = 0.01, .largest = 0.1},
                               Cloud{.count = 6000, .dimensions = 2, .smallest = 0.02, .largest = 0.02},
                               Cloud{.count = 6000, .smallest = 0.05, .largest = 0.05, .boundary = Boundary::periodic});
  const Scene scene = make_cloud(cloud, 9);
  const std::vector<Pair> expected = pairs_by_definition(scene);
  REQUIRE(expected.size() > 1000);
  for (const std::string_view method : kNames<BroadPhase>) {
    for (const int threads : {1, 2, 8}) {
      INFO(method << ", threads " << threads);
      for (int repeat = 0; repeat < 2; ++repeat) {
        REQUIRE(difference(contacts_in_world(scene, {.broadphase = std::string(method), .threads = threads}),
                           expected) == "");
      }
    }
  }
}

TEST_CASE("worlds of zero, one and two spheres are searched") {
  for (const Boundary boundary : {Boundary::walls, Boundary::open_top, Boundary::periodic}) {
    for (const int dimensions : {2, 3}) {
      for (const Way& way : ways(dimensions)) {
        INFO(way << ", dimensions " << dimensions);
        Scene scene;
        scene.domain.dimensions = dimensions;
        scene.domain.boundary = boundary;
        CHECK(contacts_in_world(scene, way).empty());
        add_sphere(scene, {0.5, 0.5, 0.5});
        CHECK(contacts_in_world(scene, way).empty());
        add_sphere(scene, {0.5, 0.59, 0.5});
        CHECK(contacts_in_world(scene, way) == std::vector<Pair>{{0, 1}});
        scene.bodies.position[1] = {0.5, 0.61, 0.5};
        CHECK(contacts_in_world(scene, way).empty());
      }
    }
  }
}

TEST_CASE("cells of half a diameter miss contacts: slide 7's bound is not enough") {
  // Two equal spheres at a distance d along x, random offset: with edge c, the pair is missed where two borders lie
  // between the centres. Here c = r, d = 1.9 r: missed in most places.
  for (const char* const method : {"linked-cell", "sorted-grid"}) {
    int missed = 0;
    Random random(3);
    for (int k = 0; k < 100; ++k) {
      Scene scene;
      scene.domain = {Vec3d(0.0), Vec3d(4.0), Boundary::walls, 3};
      const double x = random.uniform(0.5, 2.0);
      add_sphere(scene, {x, 1, 1}, Vec3d(0.0), 0.5);
      add_sphere(scene, {x + 0.95, 1, 1}, Vec3d(0.0), 0.5);
      REQUIRE(contacts_in_world(scene, {.broadphase = method, .cell_size = 1.0}).size() == 1);
      missed += contacts_in_world(scene, {.broadphase = method, .cell_size = 0.5}).empty();
    }
    // Probability that floor(x/c + 1.9) − floor(x/c) is 2: 0.9.
    CHECK(missed > 75);
    CHECK(missed < 100);
  }
}

TEST_CASE("cells of c diameters find 1 − 3(1 − c)²/(2c) of touching pairs, down to c = 1/√2") {
  // A pair at a distance d is found where no axis has two borders between the centres: with probability ∏ clamp(2 −
  // |d_i|/c, 0, 1) at a random offset. Over all directions of touching spheres of diameter 1: 0.98333 for c = 0.9, at
  // most one axis being longer than c; for c = 0.5 by integration 0.2905.
  struct Row {
    double c, recall;
  };
  for (const Row& row : {Row{0.9, 1 - 3 * 0.1 * 0.1 / (2 * 0.9)}, Row{0.5, 0.2905}}) {
    Random random(17);
    Scene scene;
    constexpr int kSide = 28;
    scene.domain = {Vec3d(0.0), Vec3d(4.0 * kSide), Boundary::walls, 3};
    for (int k = 0; k < 20000; ++k) {
      const Vec3d cell(k % kSide, k / kSide % kSide, k / kSide / kSide), n = random.direction(3);
      const Vec3d center = 4.0 * cell + 1.2 + row.c * random.uniform(Vec3d(0.0), Vec3d(1.0));
      add_sphere(scene, center - 0.4999999 * n, Vec3d(0.0), 0.5);
      add_sphere(scene, center + 0.4999999 * n, Vec3d(0.0), 0.5);
    }
    const double error = std::sqrt(row.recall * (1 - row.recall) / 20000);
    for (const char* const method : {"linked-cell", "sorted-grid"}) {
      Settings settings = settings_of({.broadphase = method, .cell_size = row.c});
      settings.precision = Precision::float64;
      const double found = double(make_cpu_world(scene, settings)->report().contacts) / 20000;
      INFO(method << ", c = " << row.c << ": " << found << " ± " << error << " for " << row.recall);
      CHECK(std::fabs(found - row.recall) < 3 * error);
    }
  }
}

TEST_CASE("the families' contacts are found by worlds and by pair searches, few spheres or many") {
  for (const FamilyInfo& family : families()) {
    for (const int count : {0, 1, 2, 3, 100, 2000}) {
      const Spheres spheres = count == 0 ? Spheres{} : make_family(family.name, count, 1);
      const bool is_flat = family.name == "floor";
      const Scene scene = scene_of(spheres);
      const std::vector<Pair> expected = pairs_by_definition(scene);
      REQUIRE(exact_pairs(arrays_of(spheres)) == expected);
      if (count == 2000) REQUIRE(expected.size() > 30);
      for (const Way& way : ways(3)) {
        INFO(family.name << ", " << count << " spheres, " << way);
        REQUIRE(difference(contacts_in_world(scene, way), expected) == "");
        REQUIRE(difference(found_pairs(spheres, way), expected) == "");
        if (is_flat && fits_a_plane(way))
          REQUIRE(difference(contacts_in_world(scene_of(spheres, 2), way), expected) == "");
      }
    }
  }
}

TEST_CASE("spheres at the last bit before a cell's border, on it and after it are found") {
  for (const char* const table : {"dense", "hashed"}) {
    for (const Boundary boundary : {Boundary::walls, Boundary::periodic}) {
      for (const double low : {0.0, -3.7, 1000.3}) {
        Scene scene;
        scene.domain = {Vec3d(low), Vec3d(low + 8), boundary, 3};
        add_sphere(scene, Vec3d(low + 1), Vec3d(0.0), 0.5);
        const Way way{.broadphase = "linked-cell", .table = table};
        const float edge = make_cpu_world(scene, settings_of(way))->inspect().grids.at(0).edge.x;
        // Pairs across each border, one diameter apart along x, give or take a few bits.
        scene.bodies = {};
        Random random(7);
        for (int k = 1; k < 7; ++k) {
          for (int bits = -3; bits <= 3; ++bits) {
            float x = static_cast<float>(low) + edge * static_cast<float>(k);
            for (int step = 0; step < std::abs(bits); ++step) x = std::nextafter(x, bits < 0 ? -1e9f : 1e9f);
            const Vec3d p(x, low + 8 * random.uniform(), low + 8 * random.uniform());
            add_sphere(scene, p, Vec3d(0.0), 0.5);
            add_sphere(scene, p + Vec3d(1.0, 0, 0), Vec3d(0.0), 0.5);
            add_sphere(scene, p - Vec3d(1.0, 0, 0), Vec3d(0.0), 0.5);
          }
        }
        const std::vector<Pair> expected = pairs_by_definition(scene);
        REQUIRE(expected.size() > 42);
        for (const char* const method : {"linked-cell", "sorted-grid"}) {
          for (const double size : {0.0, 1.0}) {
            INFO(method << ", " << table << ", from " << low);
            CHECK(difference(contacts_in_world(scene, {.broadphase = method, .table = table, .cell_size = size}),
                             expected) == "");
          }
        }
      }
    }
  }
}

TEST_CASE("spheres that touch exactly are found at any height above an open top") {
  Random random(5);
  for (int k = 0; k < 100; ++k) {
    Scene scene;
    scene.domain = {Vec3d(0.1), Vec3d(1.1), Boundary::open_top, 3};
    const float r = static_cast<float>(random.uniform(0.01, 0.1));
    for (int i = 0; i < 60; ++i) {
      const float y = static_cast<float>(std::pow(10.0, random.uniform(0, 5)));
      const double x = random.uniform(0.2, 1.0), z = random.uniform(0.2, 1.0);
      add_sphere(scene, {x, y, z}, Vec3d(0.0), r);
      add_sphere(scene, {x, std::nextafter(y + 2 * r, 0.0f), z}, Vec3d(0.0), r);
    }
    const std::vector<Pair> expected = pairs_by_definition(scene);
    REQUIRE(expected.size() > 10);
    for (const Way& way : ways(3)) {
      INFO(way << ", round " << k);
      REQUIRE(difference(contacts_in_world(scene, way), expected) == "");
    }
  }
}

TEST_CASE("a few spheres in a vast domain need little memory and are found") {
  for (const Boundary boundary : {Boundary::walls, Boundary::open_top, Boundary::periodic}) {
    for (const std::string_view method : kNames<BroadPhase>) {
      INFO(method << ", boundary " << static_cast<int>(boundary));
      Scene scene;
      scene.domain.max = Vec3d(1000.0);
      scene.domain.boundary = boundary;
      add_sphere(scene, Vec3d(1.0), Vec3d(0.0), 0.01);
      add_sphere(scene, Vec3d(1.015, 1.0, 1.0), Vec3d(0.0), 0.01);
      add_sphere(scene, Vec3d(1.0, 999.0, 1.0), Vec3d(0.0), 0.001);
      const auto world = make_cpu_world(scene, settings_of({.broadphase = std::string(method)}));
      CHECK(world->inspect().contacts == std::vector<Pair>{{0, 1}});
      CHECK(world->report().detection_bytes < 1000000);
    }
  }
}

TEST_CASE("every method but brute force finds the contacts of 100 000 spheres of each family", "[slow]") {
  for (const FamilyInfo& family : families()) {
    const Spheres spheres = make_family(family.name, 100000, 1);
    const std::vector<Pair> expected = exact_pairs(arrays_of(spheres));
    CHECK(expected.size() > 4000);
    std::vector<Way> many{
        {.broadphase = "sorted-grid", .threads = 2},     {.broadphase = "sorted-grid", .table = "hashed"},
        {.broadphase = "sorted-grid", .table = "dense"}, {.broadphase = "linked-cell", .threads = 2},
        {.broadphase = "sort-and-sweep", .threads = 2},  {.broadphase = "auto", .threads = 8}};
    if (family.name != "poly") many.push_back({.broadphase = "linked-cell", .table = "hashed"});  // crowded cells: slow
    for (const Way& way : many) {
      INFO(family.name << ", " << way);
      CHECK(difference(found_pairs(spheres, way), expected) == "");
    }
  }
}

TEST_CASE("worlds find the contacts of 100 000 spheres", "[slow]") {
  struct Row {
    const char* family;
    const char* method;
  };
  const Row row =
      GENERATE(values<Row>({{"poly", "sorted-grid"}, {"column", "sort-and-sweep"}, {"u30", "linked-cell"}}));
  const Spheres spheres = make_family(row.family, 100000, 2);
  INFO(row.family << ", " << row.method);
  CHECK(difference(contacts_in_world(scene_of(spheres), {.broadphase = row.method, .threads = 2}),
                   exact_pairs(arrays_of(spheres))) == "");
}
