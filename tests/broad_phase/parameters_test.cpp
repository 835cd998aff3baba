// SPDX-License-Identifier: MIT
// Size classes, and the volume that spheres occupy.
#include "broad_phase/parameters.h"

#include <catch2/catch.hpp>

#include "broad_phase/grid_rows.h"
#include "tests/support/body_arrays.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

std::vector<SizeClass<Vec3>> classes_of(const std::vector<float>& radius, int64_t count = -1) {
  return size_classes<Vec3>({radius.data(), static_cast<int64_t>(radius.size())},
                            count < 0 ? static_cast<int64_t>(radius.size()) : count);
}

}  // namespace

TEST_CASE("spheres of one size make one class") {
  CHECK(classes_of({}).empty());
  for (const auto& classes : {classes_of({0.5f}, 1000), classes_of(std::vector<float>(1000, 0.5f))}) {
    REQUIRE(classes.size() == 1);
    CHECK(classes[0].largest == 0.5f);
    CHECK(classes[0].count == 1000);
  }
}

TEST_CASE("size classes are steps of about 2.5, largest first, and count every sphere once") {
  const auto [ratio, expected] = GENERATE(table<double, int>({{1.4, 1}, {2.5, 1}, {10, 3}, {100, 5}, {1000, 8}}));
  std::vector<float> radius;
  for (int k = 0; k <= 1000; ++k) radius.push_back(static_cast<float>(0.01 * std::pow(ratio, k / 1000.0)));
  const auto classes = classes_of(radius);
  REQUIRE(classes.size() == static_cast<size_t>(expected));
  CHECK(classes[0].largest == radius.back());
  int64_t sum = 0;
  for (size_t k = 0; k < classes.size(); ++k) {
    sum += classes[k].count;
    if (k + 1 < classes.size())
      CHECK(classes[k].largest / classes[k + 1].largest == Approx(std::pow(ratio, 1.0 / expected)).epsilon(0.02));
  }
  CHECK(sum == 1001);
}

TEST_CASE("a sphere belongs to the class that counted it") {
  const Scene scene = make_cloud({.count = 2000, .smallest = 1e-3, .largest = 1.0, .is_log_uniform = true}, 5);
  const std::vector<float> radius(scene.bodies.radius.begin(), scene.bodies.radius.end());
  const auto classes = classes_of(radius);
  ClassGrids<Vec3> grids;
  for (const auto& spheres : classes) grids.largest[grids.count++] = spheres.largest;
  std::vector<int64_t> counts(classes.size(), 0);
  for (const float r : radius) {
    const int k = grids.class_of(r);
    CHECK(r <= classes[static_cast<size_t>(k)].largest);
    ++counts[static_cast<size_t>(k)];
  }
  for (size_t k = 0; k < classes.size(); ++k) CHECK(counts[k] == classes[k].count);
}

TEST_CASE("classes without spheres are left out, and what is too small for eight belongs to the last") {
  CHECK(classes_of({1.0f, 0.001f, 0.001f}).size() == 2);
  const auto classes = classes_of({1.0f, 1e-3f, 1e-6f, 1e-9f});
  REQUIRE(classes.size() <= 8);
  CHECK(classes.front().count == 1);
  CHECK(classes.back().largest <= 1e-3f);
  int64_t sum = 0;
  for (const auto& spheres : classes) sum += spheres.count;
  CHECK(sum == 4);
}

TEST_CASE("evenly spread points occupy the whole box, gathered ones little of it") {
  const auto occupied = [](const Scene& scene) {
    const std::vector<Vec3> points = spheres_of(scene).position;
    const auto count = static_cast<int64_t>(points.size());
    const double volume = scene.domain.dimensions == 2
                              ? occupied_volume(BodyArrays<Vec2>(scene).box, Span<const Vec3>{points.data(), count})
                              : occupied_volume(BodyArrays<Vec3>(scene).box, Span<const Vec3>{points.data(), count});
    return volume / std::pow(2.0, scene.domain.dimensions);
  };
  for (const int dimensions : {2, 3}) {
    for (const int count : {200, 3000, 50000}) {
      CHECK(occupied(make_cloud({.count = count, .dimensions = dimensions}, 1)) > 0.7);
      CHECK(occupied(make_cloud({.count = count, .dimensions = dimensions}, 1)) <= 1.0);
      CHECK(occupied(make_cloud({.count = count, .dimensions = dimensions, .clusters = 5, .scatter = 0.02}, 1)) < 0.1);
    }
    CHECK(occupied(make_cloud({.count = 1, .dimensions = dimensions}, 1)) == 1.0);
    CHECK(occupied(make_cloud({.count = 0, .dimensions = dimensions}, 1)) == 1.0);
  }
  // Half of the box filled evenly.
  Scene half = make_cloud({.count = 50000}, 1);
  for (Vec3d& p : half.bodies.position) p.x = (p.x - 1) / 2;
  CHECK(occupied(half) == Approx(0.5).epsilon(0.25));
}
