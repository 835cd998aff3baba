// SPDX-License-Identifier: MIT
// Compares the index with brute force.
#include "scene/sphere_index.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "core/random.h"

using namespace ballpit;

namespace {

struct Ball {
  Vec3d position;
  double radius;
};

struct World {
  Domain domain;
  std::vector<Ball> balls;
};

/// Sizes spread over `decades`, so that all levels are used.
World random_world(uint64_t seed, int dimensions, Boundary boundary, int decades) {
  World world;
  Random random(seed);
  world.domain.dimensions = dimensions;
  world.domain.boundary = boundary;
  world.domain.min = Vec3d(-1.3, 2.0, -0.1);
  world.domain.max = Vec3d(1.1, 4.7, 3.0);
  if (dimensions == 2) world.domain.min.z = world.domain.max.z = 0.0;
  for (int i = 0; i < 200; ++i) {
    double radius = 0.2 * random.uniform(0.5, 1.0);
    for (int k = static_cast<int>(random.uniform(0.0, decades + 1.0)); k > 0; --k) radius /= 10.0;
    world.balls.push_back({random.uniform(world.domain.min, world.domain.max), radius});
  }
  return world;
}

double distance2(const Domain& domain, Vec3d d) {
  if (domain.boundary == Boundary::periodic) {
    for (int axis = 0; axis < domain.dimensions; ++axis) {
      const double edge = domain.max[axis] - domain.min[axis];
      d[axis] -= edge * std::round(d[axis] / edge);
    }
  }
  return d.x * d.x + d.y * d.y + d.z * d.z;
}

std::vector<int32_t> near_by_brute_force(const World& world, const Ball& ball) {
  std::vector<int32_t> ids;
  for (size_t i = 0; i < world.balls.size(); ++i) {
    const double touching = ball.radius + world.balls[i].radius;
    if (distance2(world.domain, world.balls[i].position - ball.position) < touching * touching) {
      ids.push_back(static_cast<int32_t>(i));
    }
  }
  return ids;
}

std::vector<int32_t> near_by_index(const SphereIndex& index, const Ball& ball) {
  std::vector<int32_t> ids;
  index.visit_near(ball.position, ball.radius, 0.0, [&](const SphereIndex::Sphere& sphere, double) {
    ids.push_back(sphere.id);
    return false;
  });
  std::sort(ids.begin(), ids.end());
  return ids;
}

void check_against_brute_force(const World& world) {
  SphereIndex index(world.domain);
  for (size_t i = 0; i < world.balls.size(); ++i) {
    index.insert(static_cast<int32_t>(i), world.balls[i].position, world.balls[i].radius);
  }
  int disagreements = 0;
  for (const Ball& ball : world.balls) disagreements += near_by_index(index, ball) != near_by_brute_force(world, ball);
  CHECK(disagreements == 0);
}

}  // namespace

TEST_CASE("the index finds each overlapping sphere once, whatever the sizes") {
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    for (const int dimensions : {2, 3}) {
      for (const int decades : {0, 2, 6}) {
        CAPTURE(seed, dimensions, decades);
        check_against_brute_force(random_world(seed, dimensions, Boundary::walls, decades));
      }
    }
  }
}

TEST_CASE("the index finds spheres across periodic edges once") {
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    for (const int dimensions : {2, 3}) {
      CAPTURE(seed, dimensions);
      check_against_brute_force(random_world(seed, dimensions, Boundary::periodic, 1));
    }
  }
}

TEST_CASE("spheres on the borders of cells are found") {
  World world;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (const double shift : {0.0, -1e-20, 1e-20, -0.25, 0.25}) world.balls.push_back({{x + shift, y, 0.0}, 0.5});
    }
  }
  check_against_brute_force(world);
}

TEST_CASE("coordinates too large for cells are still searched") {
  World world;
  for (int i = 0; i < 40; ++i) world.balls.push_back({{1e15 + i, -1e15, 0.0}, i % 2 == 0 ? 1e-3 : 2.0});
  check_against_brute_force(world);
}

TEST_CASE("a place is free if all gaps are at least the given one") {
  SphereIndex index(Domain{});
  CHECK(index.is_free({0.5, 0.5, 0.5}, 0.1, 0.0));
  index.insert(0, {0.5, 0.5, 0.5}, 0.125);
  CHECK(index.is_free({0.75, 0.5, 0.5}, 0.125, 0.0));
  CHECK_FALSE(index.is_free({0.75, 0.5, 0.5}, 0.125, 1e-6));
  CHECK_FALSE(index.is_free({0.7499, 0.5, 0.5}, 0.125, 0.0));
  CHECK(index.size() == 1);
}
