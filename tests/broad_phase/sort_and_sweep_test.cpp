// SPDX-License-Identifier: MIT
#include "broad_phase/sort_and_sweep.h"

#include <limits>

#include <catch2/catch.hpp>

#include "tests/support/body_arrays.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

/// Spheres with these intervals on x; on y and z they all overlap.
struct Interval {
  float begin, end;
};
Spheres with_intervals(const std::vector<Interval>& intervals) {
  Spheres spheres;
  for (const Interval& interval : intervals) {
    spheres.position.emplace_back((interval.begin + interval.end) / 2, 0.01f * static_cast<float>(spheres.count()),
                                  0.0f);
    spheres.radius.push_back((interval.end - interval.begin) / 2);
  }
  return spheres;
}

std::unique_ptr<PairSearch> sweep(const Spheres& spheres, const char* axis, const char* method = "sort-and-sweep") {
  auto search = cpu_backend().make_pair_search(settings_of({.broadphase = method, .axis = axis}));
  search->find(arrays_of(spheres));
  return search;
}

}  // namespace

TEST_CASE("the unsigned order of sortable numbers is the order of floats") {
  constexpr float kInfinity = std::numeric_limits<float>::infinity(),
                  kSmallest = std::numeric_limits<float>::denorm_min();
  std::vector<float> values{-kInfinity, -1e30f, -1.5f, -1.0f, -1e-30f, -kSmallest, 0.0f,
                            kSmallest,  1e-30f, 1.0f,  1.5f,  1e30f,   kInfinity};
  Random random(1);
  for (int k = 0; k < 1000; ++k)
    values.push_back(static_cast<float>(std::pow(10, random.uniform(-9, 9)) * random.uniform(-1, 1)));
  for (const float a : values) {
    for (const float b : values) REQUIRE((a < b) == (sortable(a) < sortable(b)));
  }
}

TEST_CASE("slide 4: in the list b0 e0 b1 b2 e1 e2 the begins walk 1, 2 and 2 entries, and the ends none") {
  const Spheres spheres = with_intervals({{0, 1}, {2, 4}, {3, 5}});
  for (const char* const method : {"sort-and-sweep", "lecture/sort-and-sweep"}) {
    const auto search = sweep(spheres, "x", method);
    CHECK(search->report().candidates == 1);  // b1 meets b2
    CHECK(search->pairs() == std::vector<Pair>{{1, 2}});
  }
  CHECK(sweep(spheres, "x", "lecture/sort-and-sweep")->work_per_thread() == std::vector<int>{1, 0, 2, 2, 0, 0});
}

TEST_CASE("with the begins numbered, a thread for each begin tests the begins up to its end") {
  CHECK(sweep(with_intervals({{0, 1}, {2, 4}, {3, 5}}), "x")->work_per_thread() == std::vector<int>{0, 1, 0});
  CHECK(sweep(with_intervals({{0, 10}, {4, 5}, {6, 7}}), "x")->work_per_thread() == std::vector<int>{2, 0, 0});
}

TEST_CASE("in the list b0 b2 e0 b1 e2 e1 the begins walk 2, 3 and 2 entries, and two meet another begin") {
  const auto search = sweep(with_intervals({{0, 2}, {3, 5}, {1, 4}}), "x", "lecture/sort-and-sweep");
  CHECK(search->work_per_thread() == std::vector<int>{2, 3, 0, 2, 0, 0});
  CHECK(search->report().candidates == 2);  // b0 meets b2, b2 meets b1
}

TEST_CASE("an interval inside another one is met once") {
  const auto search = sweep(with_intervals({{0, 10}, {4, 5}}), "x", "lecture/sort-and-sweep");
  CHECK(search->work_per_thread() == std::vector<int>{3, 1, 0, 0});  // b0 b1 e1 e0
  CHECK(search->report().candidates == 1);
}

TEST_CASE("on slide 4 each list entry is a thread, and half of them return at once") {
  const Spheres spheres = make_family("u30", 500, 1);
  const std::vector<int> walks = sweep(spheres, "auto", "lecture/sort-and-sweep")->work_per_thread();
  CHECK(walks.size() == 1000);
  CHECK(std::count(walks.begin(), walks.end(), 0) == 500);
}

TEST_CASE("spheres that touch exactly are found, since begins precede ends at the same position") {
  for (const float shift : {0.0f, -3.0f, 1000.0f, 0.3f}) {
    const auto search = sweep(with_intervals({{shift, shift + 1}, {shift + 1, shift + 2}}), "x");
    CHECK(search->report().candidates == 1);
  }
}

TEST_CASE("the sweep goes along the axis on which the positions vary most") {
  for (const char* const name : {"x", "y", "z"}) {
    Vec3d stretch(1.0);
    stretch[name[0] - 'x'] = 20.0;
    const Spheres spheres =
        spheres_of(make_cloud({.count = 500, .smallest = 0.1, .largest = 0.1, .stretch = stretch}, 8));
    for (const char* const axis : {"x", "y", "z"}) {
      INFO(name << " is longest, sweep along " << axis);
      const int64_t by_itself = sweep(spheres, "auto")->report().candidates;
      const int64_t along = sweep(spheres, axis)->report().candidates;
      if (std::string(axis) == name) {
        CHECK(along == by_itself);
      } else {
        CHECK(along > 5 * by_itself);
      }
    }
  }
}

TEST_CASE("the choice of an axis is not misled by a domain far from the origin") {
  const Spheres spheres = spheres_of(make_cloud(
      {.count = 500, .low = 1e5, .high = 1e5 + 2, .smallest = 0.1, .largest = 0.1, .stretch = {1, 1, 20}}, 8));
  CHECK(sweep(spheres, "auto")->report().candidates == sweep(spheres, "z")->report().candidates);
}

TEST_CASE("an interval that reaches over a periodic border meets the first begins of the list") {
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(10.0), Boundary::periodic, 3};
  add_sphere(scene, {9.8, 5, 5}, Vec3d(0.0), 0.5);
  add_sphere(scene, {0.2, 5, 5}, Vec3d(0.0), 0.5);
  add_sphere(scene, {5.0, 5, 5}, Vec3d(0.0), 0.5);
  const auto world = make_cpu_world(scene, settings_of({.broadphase = "sort-and-sweep", .axis = "x"}));
  CHECK(world->inspect().contacts == std::vector<Pair>{{0, 1}});
  CHECK(world->report().candidates == 1);
}
