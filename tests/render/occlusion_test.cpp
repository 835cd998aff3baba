// SPDX-License-Identifier: MIT
// The light that occluders leave: the shaders' own formula, compiled as C++, against a Monte Carlo reference.
#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "core/math.h"
#include "tests/support/scenes.h"
#include "world/world.h"

using namespace ballpit;

namespace {

namespace shader {
using namespace glm;  // NOLINT: as in GLSL
#include "shaders/occlusion/occlusion.glsl"
}  // namespace shader

/// Directions above the plane of a normal, spread by the cosine, one in each cell of a jittered grid.
std::vector<Vec3> directions_around(const Vec3& normal, int per_side) {
  const Vec3 aside = normalize(glm::cross(normal, std::abs(normal.x) < 0.5f ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  const Vec3 across = glm::cross(normal, aside);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> part(0, 1);
  std::vector<Vec3> result;
  for (int i = 0; i < per_side; ++i) {
    for (int j = 0; j < per_side; ++j) {
      const float u = (float(i) + part(random)) / float(per_side),
                  angle = 6.2831853f * (float(j) + part(random)) / float(per_side);
      const float r = std::sqrt(u);
      result.push_back(r * std::cos(angle) * aside + r * std::sin(angle) * across + std::sqrt(1 - u) * normal);
    }
  }
  return result;
}

bool is_hit(const Vec3& way, const Vec3& direction, float radius) {
  const float along = dot(way, direction);
  return along > 0 && dot(way, way) - along * along < radius * radius;
}

/// The share of the sky that these spheres hide together.
float measured_share(const std::vector<Vec3>& ways, const std::vector<float>& radii, const Vec3& normal, int per_side) {
  int hidden = 0, all = 0;
  for (const Vec3& direction : directions_around(normal, per_side)) {
    ++all;
    for (size_t k = 0; k < ways.size(); ++k) {
      if (!is_hit(ways[k], direction, radii[k])) continue;
      ++hidden;
      break;
    }
  }
  return float(hidden) / float(all);
}

}  // namespace

TEST_CASE("a sphere hides as much of the sky as a Monte Carlo reference says, cut by the horizon or not") {
  const Vec3 normal = normalize(Vec3(0.3f, 0.8f, -0.5f));
  const Vec3 aside = normalize(glm::cross(normal, Vec3(1, 0, 0)));
  int cut = 0, whole = 0;
  for (const float distance : {1.0001f, 1.1f, 1.5f, 2.0f, 4.0f}) {    // of the centre from the point [radii]
    for (const float angle : {0.0f, 0.6f, 1.2f, 1.5f, 1.8f, 2.3f}) {  // of the centre from the normal
      const float radius = 0.7f;
      const Vec3 way = radius * distance * (std::cos(angle) * normal + std::sin(angle) * aside);
      const float exact = measured_share({way}, {radius}, normal, 1500);
      const float share = shader::hidden_share(way, normal, radius);
      CAPTURE(distance, angle, exact);
      CHECK(share == Approx(exact).epsilon(0.02).margin(1e-4));
      CHECK(std::abs(shader::rough_share(way, normal, radius) - exact) < 0.245f);  // 0.24 where they touch
      const bool is_cut = std::abs(std::cos(angle)) < 1 / distance;
      (is_cut ? cut : whole) += exact > 0;
    }
  }
  CHECK(cut > 5);
  CHECK(whole > 5);
}

TEST_CASE("a sphere below the horizon hides nothing, and one that holds the point half of the sky at its edge") {
  const Vec3 up(0, 1, 0);
  CHECK(shader::hidden_share(Vec3(0, -2, 0), up, 1) == 0);
  CHECK(shader::hidden_share(Vec3(3, -1.01f, 0), up, 1) == Approx(0).margin(1e-5));
  CHECK(shader::hidden_share(Vec3(1, 0, 0), up, 1) == Approx(0.5f).margin(1e-4));
}

TEST_CASE("a shadow is whole behind a sphere, half at its edge, and none before it") {
  const Vec3 light(0, 1, 0);
  CHECK(shader::light_left(Vec3(0, 3, 0), light, 1) < 0.02f);
  CHECK(shader::light_left(Vec3(1, 3, 0), light, 1) == Approx(0.5f));
  CHECK(shader::light_left(Vec3(3, 3, 0), light, 1) == 1);
  CHECK(shader::light_left(Vec3(0, -3, 0), light, 1) == 1);
  CHECK(shader::light_left(Vec3(0.5f, 9, 0), light, 1) > shader::light_left(Vec3(0.5f, 3, 0), light, 1));
}

TEST_CASE("in a heap, the strongest occluders leave about as much of the sky as all spheres do") {
  // A heap that has settled, without walls and floor: the points of its surface that a viewer sees.
  Scene scene;
  scene.domain.boundary = Boundary::open_top;
  scene.physics = {.gravity = {0, -9.81, 0}, .restitution = 0.3, .wall_restitution = 0.3};
  for (int k = 0; k < 343; ++k) {
    const Vec3d cell(k % 7, k / 49, k / 7 % 7);
    add_sphere(scene, 0.07 + 0.14 * cell + Vec3d(0.004 * (k % 5), 0, 0.003 * (k % 3)), Vec3d(0.0), 0.06);
  }
  Settings settings;
  settings.dt = 1.0 / 240;
  const auto world = cpu_backend().make_world(scene, settings);
  while (world->time() < 1.5) world->step();
  const BodySnapshot bodies = world->inspect({.occluders = true}).bodies;

  const Vec3 towards_eye = normalize(Vec3(0.5f, 0.35f, 0.8f));
  double sum_of_errors = 0, sum_of_squares = 0;
  int points = 0;
  for (int64_t i = 0; i < bodies.count; ++i) {
    const float radius = bodies.radius_of(i);
    for (const Vec3& normal : directions_around(towards_eye, 3)) {
      const Vec3 point = bodies.position_of(i) + radius * normal;
      std::vector<Vec3> ways;
      std::vector<float> radii;
      for (int64_t j = 0; j < bodies.count; ++j) {
        if (j == i) continue;
        ways.push_back(bodies.position_of(j) - point);
        radii.push_back(bodies.radius_of(j));
      }
      bool is_seen = true;
      for (size_t k = 0; k < ways.size(); ++k) is_seen &= !is_hit(ways[k], towards_eye, radii[k]);
      if (!is_seen) continue;
      const float exact = 1 - measured_share(ways, radii, normal, 12);
      const Occluders& own = bodies.occluders[static_cast<size_t>(i)];
      float left = 1 - std::clamp(own.others + dot(own.others_by_normal, normal), 0.0f, 1.0f);
      for (const Occluder& other : own.strongest) {
        if (other.radius > 0) left *= 1 - shader::hidden_share(other.way - radius * normal, normal, other.radius);
      }
      sum_of_errors += left - exact;
      sum_of_squares += (left - exact) * (left - exact);
      ++points;
    }
  }
  const double mean = sum_of_errors / points, deviation = std::sqrt(sum_of_squares / points);
  WARN("a heap's light, " << points << " points: " << mean << " too much on average, root mean square " << deviation);
  CHECK(std::abs(mean) < 0.08);
  CHECK(deviation < 0.2);
}
