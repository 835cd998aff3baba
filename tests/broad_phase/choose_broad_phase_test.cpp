// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "broad_phase/grid.h"
#include "broad_phase/parameters.h"
#include "core/error.h"
#include "methods/methods.h"
#include "tests/support/body_arrays.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

Settings automatic() { return settings_of({.broadphase = "auto"}); }

BroadPhaseChoice choice_for(const Scene& scene, const Settings& settings = automatic()) {
  if (scene.domain.dimensions == 2) return choose_broad_phase(settings, BodyArrays<Vec2>(scene).parameters(settings));
  return choose_broad_phase(settings, BodyArrays<Vec3>(scene).parameters(settings));
}

}  // namespace

TEST_CASE("a method that is asked for is taken, without a reason") {
  for (const char* const method : {"brute-force", "sort-and-sweep", "linked-cell", "sorted-grid"}) {
    const BroadPhaseChoice choice = choice_for(make_cloud({}, 1), settings_of({.broadphase = method}));
    CHECK(name_of(choice.method) == method);
    CHECK(choice.reason.empty());
  }
}

TEST_CASE("a choice is a method that there is, with a reason that names the number of spheres and all predictions") {
  for (const int count : {2, 100, 3000, 50000}) {
    const BroadPhaseChoice choice = choice_for(make_cloud({.count = count, .smallest = 0.01, .largest = 0.01}, 1));
    const auto names = kNames<BroadPhase>;
    CHECK(std::count(names.begin(), names.end(), name_of(choice.method)) == 1);
    CHECK(choice.method != BroadPhase::automatic);
    CHECK_THAT(choice.reason, Catch::Contains(std::to_string(count) + " spheres"));
    CHECK_FALSE(is_of_lecture(choice.method));
    for (const std::string_view name : names) {
      if (name != "auto" && !is_of_lecture(named<BroadPhase>(name)))
        CHECK_THAT(choice.reason, Catch::Contains(std::string(name)));
    }
    // The chosen one comes first.
    CHECK(choice.reason.find(name_of(choice.method)) <
          choice.reason.find(choice.method == BroadPhase::brute_force ? "sorted-grid" : "brute-force"));
  }
}

TEST_CASE("few spheres are tested one against the other") {
  for (const int dimensions : {2, 3}) {
    for (const int count : {0, 1, 2, 10, 30}) {
      const BroadPhaseChoice choice = choice_for(make_cloud({.count = count, .dimensions = dimensions}, 1));
      INFO(count << " spheres, dimensions " << dimensions);
      CHECK(choice.method == BroadPhase::brute_force);
      CHECK_FALSE(choice.reason.empty());
    }
  }
}

TEST_CASE("many spheres are sorted into a grid") {
  for (const char* const family : {"u05", "u30", "pile", "poly"}) {
    INFO(family);
    CHECK(choice_for(scene_of(make_family(family, 50000, 1))).method == BroadPhase::sorted_grid);
  }
  CHECK(choice_for(make_cloud({.count = 50000, .dimensions = 2, .smallest = 0.002, .largest = 0.002}, 1)).method ==
        BroadPhase::sorted_grid);
}

TEST_CASE("worlds and pair searches report their choice and its reason") {
  const Scene scene = make_cloud({.count = 20}, 1);
  const Report report = make_cpu_world(scene, automatic())->report();
  CHECK(report.broadphase == "brute-force");
  CHECK_THAT(report.broadphase_reason, Catch::Contains("20 spheres"));
  const auto search = cpu_backend().make_pair_search(automatic());
  const Spheres spheres = spheres_of(scene);
  search->find(arrays_of(spheres));
  CHECK(search->report().method == "brute-force");
  CHECK_THAT(search->report().reason, Catch::Contains("20 spheres"));
}

TEST_CASE("settings and radii make parameters") {
  const BodyArrays<Vec2> planar(make_cloud({.count = 100, .dimensions = 2, .smallest = 0.01, .largest = 0.1}, 1));
  const auto parameters = planar.parameters(settings_of({.table = "hashed", .axis = "y", .cell_size = 1.5}));
  CHECK(parameters.count == 100);
  CHECK(parameters.cell_size == 1.5);
  CHECK(parameters.table == CellTable::hashed);
  CHECK(parameters.axis == 1);
  CHECK(parameters.largest_radius() == *std::max_element(planar.radius.begin(), planar.radius.end()));
  CHECK(planar.parameters({}).table == CellTable::automatic);
  CHECK(planar.parameters({}).axis == kAutoAxis);
  CHECK(planar.parameters(settings_of({.table = "dense"})).table == CellTable::dense);
}

TEST_CASE("a planar scene has no axis z to sweep along") {
  const Settings settings = settings_of({.axis = "z"});
  CHECK_THROWS_AS(choice_for(make_cloud({.dimensions = 2}, 1), settings), UserError);
  CHECK_THROWS_WITH(choice_for(make_cloud({.dimensions = 2}, 1), settings),
                    Catch::Contains("--axis: found z, allowed auto, x, y"));
  CHECK_NOTHROW(choice_for(make_cloud({}, 1), settings));
}
