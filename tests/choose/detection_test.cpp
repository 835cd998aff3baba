// SPDX-License-Identifier: MIT
#include "choose/detection.h"

#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "measure/search_costs.h"
#include "tests/support/scenes.h"

using namespace ballpit;

TEST_CASE("a search is chosen among those that are not given, and changes no bit of the motion") {
  const Scene scene = make_crowd(3, 8, Boundary::walls, 0.9, 0.05, 0.06);
  Settings settings;
  settings.broadphase = BroadPhase::sort_and_sweep;
  settings.threads = 1;
  const Settings kept =
      with_cheapest_search(scene, {}, settings, {{"broadphase", "sort-and-sweep"}, {"skin", "0"}, {"threads", "1"}},
                           512, 0.1)
          .settings;
  CHECK(kept.broadphase == BroadPhase::sort_and_sweep);
  CHECK(skin_of(kept) == 0);
  CHECK(kept.threads == 1);
  const CheapestSearch chosen = with_cheapest_search(scene, {}, settings, {}, 512, 0.1);
  CHECK(chosen.ratio <= 1);
  const auto a = make_cpu_world(scene, settings), b = make_cpu_world(scene, chosen.settings);
  for (int k = 0; k < 50; ++k) {
    a->step();
    b->step();
  }
  CHECK(a->report().state_hash == b->report().state_hash);
}

TEST_CASE("more spheres than are piloted get all threads") {
  const Scene scene = make_crowd(3, 6, Boundary::walls, 0.9, 0.05, 0.06);
  Settings settings;
  settings.threads = 1;
  CHECK(with_cheapest_search(scene, {}, settings, {}, 100'000, 0.05).settings.threads == 0);
}

TEST_CASE("by the costs that are measured here, few spheres are tested one against the other, and many are not") {
  Settings settings;
  settings.broadphase = BroadPhase::automatic;
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    settings.precision = precision;
    settings.costs = measure_search_costs(cpu_backend(), precision);
    const auto chosen = [&](int count, double radius) {
      return make_cpu_world(make_cloud({.count = count, .smallest = radius, .largest = radius}, 1), settings)
          ->report()
          .broadphase;
    };
    CHECK(chosen(3, 0.05) == "brute-force");
    CHECK(chosen(30'000, 0.01) != "brute-force");
  }
}

TEST_CASE("a machine that tests pairs slowly avoids brute force") {
  Settings settings;
  settings.broadphase = BroadPhase::automatic;
  const Scene scene = make_cloud({.count = 200, .smallest = 0.02, .largest = 0.02}, 1);
  settings.costs.vector_test = 1e-3;
  CHECK(make_cpu_world(scene, settings)->report().broadphase == "brute-force");
  settings.costs.vector_test = 1e3;
  CHECK(make_cpu_world(scene, settings)->report().broadphase == "sorted-grid");
}

TEST_CASE("costs are kept, and an unreadable file counts as empty") {
  const auto folder = std::filesystem::temp_directory_path() / "ballpit-costs-test";
  std::filesystem::remove_all(folder);
  setenv("XDG_CACHE_HOME", folder.c_str(), 1);
  const SearchCosts first = search_costs(cpu_backend(), Precision::float32);
  const auto file = folder / "ballpit" / "costs.json";
  REQUIRE(std::filesystem::exists(file));
  CHECK(search_costs(cpu_backend(), Precision::float32).bin == first.bin);
  std::ofstream(file) << "nonsense";
  CHECK(search_costs(cpu_backend(), Precision::float32).bin > 0);
  const SearchCosts again = search_costs(cpu_backend(), Precision::float32);
  CHECK(search_costs(cpu_backend(), Precision::float64).bin > 0);
  CHECK(search_costs(cpu_backend(), Precision::float32).bin == again.bin);  // both are kept
  std::filesystem::remove_all(folder);
  setenv("XDG_CACHE_HOME", "/proc/nowhere", 1);
  CHECK(search_costs(cpu_backend(), Precision::float32).bin > 0);  // a folder that cannot be written
  unsetenv("XDG_CACHE_HOME");
}
