// SPDX-License-Identifier: MIT
// The two exact references agree: the sweep of `ballpit pairs --check` and the definition that tests use.
#include "measure/exact_pairs.h"

#include <catch2/catch.hpp>

#include "core/random.h"
#include "tests/support/oracle.h"

using namespace ballpit;

namespace {

/// In a box of this size. A `step` above 0 puts them on a lattice of that width, where many touch exactly.
Spheres scattered(const Vec3d& box, double least_radius, double largest_radius, double step = 0) {
  Random random(11);
  Spheres spheres;
  for (int k = 0; k < 800; ++k) {
    Vec3d p = random.uniform(-box, box);
    if (step > 0) p = Vec3d(std::round(p.x / step), std::round(p.y / step), std::round(p.z / step)) * step;
    spheres.position.push_back(narrow<Vec3>(p));
    spheres.radius.push_back(static_cast<float>(random.uniform(least_radius, largest_radius)));
  }
  return spheres;
}

}  // namespace

TEST_CASE("the sweep finds what the definition says") {
  const std::vector<Spheres> families{
      scattered(Vec3d(1), 0.02, 0.1),      scattered(Vec3d(1), 1e-6, 0.3),        scattered(Vec3d(1, 1, 0), 0.01, 0.05),
      scattered(Vec3d(0, 1e3, 0), 0.5, 1), scattered(Vec3d(0, 0, 1), 0.001, 0.1), scattered(Vec3d(1), 0.05, 0.05, 0.1),
      scattered(Vec3d(0), 1, 1),           scattered(Vec3d(1e6), 3e4, 1e5),       scattered(Vec3d(1e-9), 1e-11, 1e-10),
      scattered(Vec3d(1), 2, 3),
  };
  for (const Spheres& spheres : families) {
    const std::vector<Pair> expected = pairs_by_definition(scene_of(spheres));
    INFO("family " << &spheres - families.data() << ": " << expected.size() << " pairs");
    CHECK_FALSE(expected.empty());
    CHECK((exact_pairs(arrays_of(spheres)) == expected));
  }
}

TEST_CASE("the sweep takes one radius for all") {
  Spheres spheres = scattered(Vec3d(1), 0.1, 0.2);
  spheres.radius.resize(1);
  CHECK((exact_pairs(arrays_of(spheres)) == pairs_by_definition(scene_of(spheres))));
  CHECK(exact_pairs({}).empty());
}

TEST_CASE("the sweep finds pairs across the ends of a period, as the definition says") {
  struct Family {
    Spheres spheres;
    Vec3 low, high;
  };
  const std::vector<Family> families{
      {scattered(Vec3d(1), 0.02, 0.1), Vec3(-1), Vec3(1)},
      {scattered(Vec3d(1, 2, 0.5), 0.02, 0.1), Vec3(-1, -2, -0.5f), Vec3(1, 2, 0.5f)},
      {scattered(Vec3d(1), 0.2, 0.5), Vec3(-1), Vec3(1)},  // a period of exactly four radii
      {scattered(Vec3d(1), 0.1, 0.1, 0.2), Vec3(-1), Vec3(1)},
      {scattered(Vec3d(1e-9), 1e-11, 1e-10), Vec3(-1e-9f), Vec3(1e-9f)},
  };
  for (const auto& [spheres, low, high] : families) {
    SphereArrays arrays = arrays_of(spheres);
    arrays.period = Box<Vec3>{low, high, Boundary::periodic};
    Scene scene = scene_of(spheres);
    const size_t without_period = pairs_by_definition(scene).size();
    scene.domain = {widen(low), widen(high), Boundary::periodic, 3};
    const std::vector<Pair> expected = pairs_by_definition(scene);
    CHECK(expected.size() > without_period);
    CHECK((exact_pairs(arrays) == expected));
  }
}

TEST_CASE("missed, wrong and duplicate pairs are distinguished") {
  const std::vector<Pair> exact{{0, 1}, {0, 4}, {2, 3}, {5, 6}};
  const auto deviation = [&](std::vector<Pair> found) {
    const Deviation d = deviation_of(std::move(found), exact);
    return std::vector<int64_t>{d.missed, d.wrong, d.duplicate};
  };
  using Numbers = std::vector<int64_t>;
  CHECK(deviation(exact) == Numbers{0, 0, 0});
  CHECK(deviation({}) == Numbers{4, 0, 0});
  CHECK(deviation({{0, 1}, {2, 3}}) == Numbers{2, 0, 0});
  CHECK(deviation({{0, 1}, {0, 1}, {0, 1}, {0, 4}, {2, 3}, {5, 6}}) == Numbers{0, 0, 2});
  CHECK(deviation({{0, 1}, {0, 2}, {0, 4}, {2, 3}, {5, 6}, {7, 8}}) == Numbers{0, 2, 0});
  CHECK(deviation({{1, 0}, {0, 4}, {2, 3}, {5, 6}}) == Numbers{1, 1, 0});
  CHECK(deviation({{5, 6}, {2, 3}, {0, 4}, {0, 1}}) == Numbers{0, 0, 0});
}
