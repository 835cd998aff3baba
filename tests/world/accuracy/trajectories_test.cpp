// SPDX-License-Identifier: MIT
// Paths against those of exact motion, below the horizon of chaos: 108 hard spheres in a periodic box at ρ = 0.1 (diameter,
// mass and kT are 1), about one collision per sphere. Errors grow by 2.5 e-folds a collision and sphere there, twelvefold.
#include <cmath>

#include <catch2/catch.hpp>

#include "tests/support/hard_sphere_gas.h"
#include "tests/support/hits.h"

using namespace ballpit;

namespace {

constexpr double kTime = 1.25;

/// A start with where exact motion leads.
struct Course {
  Scene scene;
  Bodies end;
};

std::vector<Course> courses() {
  std::vector<Course> list;
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    const Scene scene = melted_gas(3, 0.1, seed);
    const auto world = make_cpu_world(scene, event_driven_gas(kTime));
    world->step();
    list.push_back({scene, world->bodies()});
  }
  return list;
}

/// The median of the spheres' distances from where they should be [m], over all courses.
double median_error(const std::vector<Course>& all, const Settings& settings, double stiffness = 1e5) {
  std::vector<double> errors;
  for (const Course& course : all) {
    Scene scene = course.scene;
    scene.physics.stiffness = stiffness;
    const auto world = make_cpu_world(scene, settings);
    step_until(*world, kTime - settings.dt / 2);
    const Bodies end = world->bodies();
    const Vec3d period = scene.domain.max - scene.domain.min;
    for (size_t i = 0; i < end.position.size(); ++i) {
      const Vec3d d = end.position[i] - course.end.position[i];
      errors.push_back(length(d - period * glm::round(d / period)));
    }
  }
  std::nth_element(errors.begin(), errors.begin() + static_cast<int64_t>(errors.size() / 2), errors.end());
  return errors[errors.size() / 2];
}

Settings steps_of(const std::string& response, double steps) {
  Settings settings = settings_of(response, kTime / steps);
  settings.broadphase = BroadPhase::sorted_grid;
  return settings;
}

/// The order at which errors fall from the first to the last of a row, each for half of what the one before had.
double order_of(const std::vector<double>& errors) {
  return std::log2(errors.front() / errors.back()) / double(errors.size() - 1);
}

}  // namespace

TEST_CASE("paths by impulses approach the exact ones in the first order of dt") {
  // A hit comes up to dt late.
  const std::vector<Course> all = courses();
  std::vector<double> errors;
  for (const double steps : {128, 256, 512, 1024}) errors.push_back(median_error(all, steps_of("impulse", steps)));
  INFO(errors[0] << ", " << errors[1] << ", " << errors[2] << ", " << errors[3] << ": order " << order_of(errors));
  CHECK(std::is_sorted(errors.rbegin(), errors.rend()));
  CHECK(order_of(errors) > 0.7);
  CHECK(order_of(errors) < 1.3);
}

TEST_CASE("paths by springs approach the exact ones in the first order of a contact's duration, 1/√k") {
  const std::vector<Course> all = courses();
  std::vector<double> errors;
  for (const double stiffness : {1e4, 4e4, 16e4}) {
    const double duration = M_PI * std::sqrt(0.5 / stiffness);  // 20 steps each
    errors.push_back(median_error(all, steps_of("penalty", std::ceil(20 * kTime / duration)), stiffness));
  }
  INFO(errors[0] << ", " << errors[1] << ", " << errors[2] << ": order " << order_of(errors));
  CHECK(std::is_sorted(errors.rbegin(), errors.rend()));
  CHECK(order_of(errors) > 0.7);
  CHECK(order_of(errors) < 1.3);
}

TEST_CASE("paths by swept impulses are exact but for rounding, where no sphere hits twice in a step") {
  const std::vector<Course> all = courses();
  for (const double steps : {64, 512}) {
    Settings settings = steps_of("impulse", steps);
    settings.is_swept = true;
    INFO(steps << " steps");
    CHECK(median_error(all, settings) < 1e-11);
  }
}
