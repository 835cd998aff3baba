// SPDX-License-Identifier: MIT
// Simultaneous impacts: edges and corners, one ball that hits two, two that hit one. The numbers are those of the table
// in docs/responses.md.
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/hits.h"

using namespace ballpit;

namespace {

Settings method(const std::string& response, double dt, bool is_swept = false, const std::string& solver = "jacobi",
                int iterations = 4) {
  Settings settings = settings_of(response, dt);
  settings.is_swept = is_swept;
  settings.solver = named<Solver>(solver);
  if (response == "impulse") settings.iterations = iterations;
  return settings;
}

struct Ball {
  Vec3d position, velocity;
};

/// Velocities after 2 s of balls of mass 1 and diameter 1 that are written in this order; in the order of `balls`.
std::vector<Vec3d> after(const std::vector<Ball>& balls, const std::vector<size_t>& order, double e,
                         const Settings& settings) {
  Scene scene = wide_box();
  scene.physics.restitution = e;
  for (const size_t k : order) add_sphere(scene, balls[k].position, balls[k].velocity, 0.5);
  const auto world = make_cpu_world(scene, settings);
  step_until(*world, 2);
  std::vector<Vec3d> result(balls.size());
  for (size_t k = 0; k < order.size(); ++k) result[order[k]] = world->bodies().velocity[k];
  return result;
}

const std::vector<std::vector<size_t>> kOrders{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

/// One ball that hits two touching ones at the same time.
const std::vector<Ball> kBreak{{{-2, 0, 0}, {1, 0, 0}}, {{0, -0.5, 0}, Vec3d(0)}, {{0, 0.5, 0}, Vec3d(0)}};
/// Two balls that hit one at rest between them.
const std::vector<Ball> kBetween{{{-2, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, Vec3d(0)}, {{2, 0, 0}, {-1, 0, 0}}};

}  // namespace

TEST_CASE("a ball that runs into an edge or a corner keeps e of its speed along each axis, by every response",
          "[slow]") {
  for (const Settings& settings :
       {method("impulse", 1e-3), method("impulse", 1e-3, false, "jacobi", 1), method("impulse", 1e-2, true),
        method("impulse", 1e-3, false, "gauss-seidel"), method("impulse", 1e-2, true, "gauss-seidel"),
        method("kinematic", 1e-3), method("kinematic", 1e-2, true), method("penalty", 1e-5),
        method("position-based", 1e-3), method("event-driven", 1e-2)}) {
    for (const Vec3d& way : {Vec3d(1, 1, 0), Vec3d(1, 1, 1), Vec3d(-1, 1, -1), Vec3d(0, -1, 1)}) {
      Scene scene = wide_box(2);
      scene.physics.wall_restitution = 0.8;
      add_sphere(scene, Vec3d(0), way, 0.5);
      const auto world = make_cpu_world(scene, settings);
      step_until(*world, 2);
      INFO(name_of(settings.response) << ", swept " << settings.is_swept << ", " << name_of(settings.solver));
      CHECK(length(world->bodies().velocity[0] + 0.8 * way) < 1e-3);
    }
  }
}

TEST_CASE("a ball in a corner that rests on others keeps no more speed than e") {
  Scene scene = wide_box(2);
  scene.physics.restitution = scene.physics.wall_restitution = 0.8;
  add_sphere(scene, {1, 1, 1}, {1, 1, 1}, 0.5);
  add_sphere(scene, {0.2, 0.6, 1}, {0, 0, 0}, 0.3);
  for (const char* const response : {"impulse", "kinematic"}) {
    for (const bool is_swept : {false, true}) {
      const auto world = make_cpu_world(scene, method(response, 1e-3, is_swept));
      double last = world->report().kinetic_energy;
      for (int k = 0; k < 2000; ++k) {
        world->step();
        const double now = world->report().kinetic_energy;
        CHECK(now <= last * (1 + 1e-9));
        last = now;
      }
    }
  }
}

TEST_CASE("a break is symmetric, whatever the order of the balls, where all impacts are answered at once", "[slow]") {
  struct Row {
    Settings settings;
    double cue, along, across;      // e = 1
    double cue_lossy, along_lossy;  // e = 0.8
  };
  // At once, exactly: −1/5, 3/5 and 3/5·tan 30°; with e: (1 − 6(1 + e)/10), 3(1 + e)/10.
  for (const Row& row :
       {Row{method("impulse", 1e-3), -0.1763, 0.5881, 0.3396, -0.0586, 0.5293},
        Row{method("impulse", 1e-2, true), -0.1763, 0.5881, 0.3396, -0.0586, 0.5293},
        Row{method("impulse", 1e-3, false, "jacobi", 64), -0.2, 0.6, 0.3464, -0.08, 0.54},
        Row{method("impulse", 1e-3, false, "gauss-seidel"), -0.2, 0.6, 0.3464, -0.08, 0.54},
        Row{method("impulse", 1e-2, true, "gauss-seidel"), -0.2, 0.6, 0.3464, -0.08, 0.54},
        Row{method("kinematic", 1e-3), -1, 0, 0, -0.8, 0}, Row{method("kinematic", 1e-2, true), -1, 0, 0, -0.8, 0},
        Row{method("penalty", 1e-5), -0.1994, 0.5997, 0.3471, -0.0671, 0.5336}}) {
    INFO(name_of(row.settings.response) << ", swept " << row.settings.is_swept << ", " << name_of(row.settings.solver));
    // A normal that is met 1 mm late is turned by about as much; the last digits are those of the order.
    for (const std::vector<size_t>& order : kOrders) {
      const std::vector<Vec3d> v = after(kBreak, order, 1, row.settings),
                               lossy = after(kBreak, order, 0.8, row.settings);
      CHECK(v[0].x == Approx(row.cue).margin(1e-3));
      CHECK(std::fabs(v[0].y) < 1e-4);
      CHECK(length(v[1] - Vec3d(row.along, -row.across, 0)) < 1e-3);
      CHECK(length(v[2] - Vec3d(row.along, row.across, 0)) < 1e-3);
      CHECK(lossy[0].x == Approx(row.cue_lossy).margin(1e-3));
      CHECK(lossy[1].x == Approx(row.along_lossy).margin(1e-3));
      CHECK(lossy[2].x == Approx(row.along_lossy).margin(1e-3));
    }
  }
}

TEST_CASE("one after another, a break depends on the order of the two balls alone, and mirrors with it") {
  for (const Settings& settings : {method("event-driven", 1e-2), method("position-based", 1e-3)}) {
    const std::vector<Vec3d> first = after(kBreak, {0, 1, 2}, 1, settings),
                             second = after(kBreak, {0, 2, 1}, 1, settings);
    INFO(name_of(settings.response));
    CHECK(std::fabs(first[0].y) > 0.05);
    for (const auto& [a, b] : {std::pair{0, 0}, {1, 2}, {2, 1}}) {
      CHECK(length(first[size_t(a)] - Vec3d(1, -1, 1) * second[size_t(b)]) < 1e-9);
    }
  }
  const std::vector<Vec3d> exact = after(kBreak, {0, 1, 2}, 1, method("event-driven", 1e-2));
  CHECK(length(exact[0] - Vec3d(-0.125, std::sqrt(3) / 8, 0)) < 1e-9);
  CHECK(length(exact[1] - Vec3d(0.75, -std::sqrt(3) / 4, 0)) < 1e-9);
  CHECK(length(exact[2] - Vec3d(0.375, std::sqrt(3) / 8, 0)) < 1e-9);
}

TEST_CASE("a ball that two strike at once stays at rest, and they return alike", "[slow]") {
  struct Row {
    Settings settings;
    double elastic, lossy;  ///< speed of the two at e = 1 and e = 0.8
    double unlike;          ///< how far the outcome may depend on the order
  };
  for (const Row& row :
       {Row{method("impulse", 1e-3), 0.6049, 0.4444, 1e-9}, Row{method("impulse", 1e-2, true), 0.6049, 0.4444, 1e-9},
        Row{method("impulse", 1e-3, false, "jacobi", 64), 1, 0.8, 1e-9},
        Row{method("impulse", 1e-3, false, "gauss-seidel"), 0.988, 0.789, 0.008},
        Row{method("impulse", 1e-3, false, "gauss-seidel", 32), 1, 0.8, 1e-6},
        Row{method("kinematic", 1e-3), 1, 0.8, 1e-9}, Row{method("kinematic", 1e-2, true), 1, 0.8, 1e-9},
        Row{method("penalty", 1e-5), 1, 0.8541, 1e-9}, Row{method("event-driven", 1e-2), 1, 0.95, 0.1}}) {
    INFO(name_of(row.settings.response) << ", swept " << row.settings.is_swept << ", " << name_of(row.settings.solver));
    for (const std::vector<size_t>& order : kOrders) {
      const std::vector<Vec3d> v = after(kBetween, order, 1, row.settings),
                               lossy = after(kBetween, order, 0.8, row.settings);
      CHECK(std::fabs(v[1].x) <= row.unlike + 1e-6);
      CHECK((v[2].x - v[0].x) / 2 == Approx(row.elastic).margin(1e-3));
      CHECK(std::fabs(v[2].x + v[0].x) <= row.unlike + 1e-6);
      CHECK((lossy[2].x - lossy[0].x) / 2 == Approx(row.lossy).margin(1e-3));
    }
  }
}
