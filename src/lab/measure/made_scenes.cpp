// SPDX-License-Identifier: MIT
#include "lab/measure/made_scenes.h"

#include <chrono>

#include "core/error.h"
#include "core/interrupt.h"
#include "core/random.h"
#include "measure/theory.h"

namespace ballpit {

namespace {

/// Random velocities of spheres of mass 1, with total momentum 0 and kT = 1.
void set_velocities(Bodies& bodies, Random& random) {
  for (Vec3d& v : bodies.velocity) {
    v = random.uniform(Vec3d(-1.0), Vec3d(1.0)) + random.uniform(Vec3d(-1.0), Vec3d(1.0));
  }
  stop_center(bodies);
  double squared = 0;
  for (const Vec3d& v : bodies.velocity) squared += dot(v, v);
  for (Vec3d& v : bodies.velocity) v *= std::sqrt(3 * (static_cast<double>(bodies.mass.size()) - 1) / squared);
}

Scene lattice_gas(int cells, double rho, uint64_t seed) {
  const double edge = std::cbrt(4 / rho);
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(cells * edge), Boundary::periodic, 3};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  for (const Vec3d& site : fcc_lattice(cells, edge)) put_sphere(scene, site, Vec3d(0.0), 0.5, 1);
  Random random(seed);
  set_velocities(scene.bodies, random);
  return scene;
}

/// Moves the bodies exactly for a time.
void relax(Scene& scene, double time) {
  const auto world = make_world_on_cpu(scene, exact_motion(time));
  world->step();
  scene.bodies = world->bodies();
}

}  // namespace

void put_sphere(Scene& scene, const Vec3d& position, const Vec3d& velocity, double radius, double mass) {
  scene.bodies.position.push_back(position);
  scene.bodies.velocity.push_back(velocity);
  scene.bodies.radius.push_back(radius);
  scene.bodies.mass.push_back(mass);
}

Scene wide_box(double half) {
  Scene scene;
  scene.domain.min = Vec3d(-half);
  scene.domain.max = Vec3d(half);
  scene.physics.restitution = scene.physics.wall_restitution = 1.0;
  return scene;
}

Scene make_stack(const std::vector<double>& masses, double radius) {
  Scene scene;
  scene.domain.min = {-5 * radius, 0, -5 * radius};
  scene.domain.max = {5 * radius, 2 * radius * (static_cast<double>(masses.size()) + 2), 5 * radius};
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 0;
  double height = radius;
  for (const double mass : masses) {
    put_sphere(scene, {0, height, 0}, Vec3d(0.0), radius, mass);
    height += 2 * radius;
  }
  return scene;
}

void stop_center(Bodies& bodies) {
  Vec3d momentum(0.0);
  double mass = 0;
  for (size_t i = 0; i < bodies.mass.size(); ++i) {
    momentum += bodies.mass[i] * bodies.velocity[i];
    mass += bodies.mass[i];
  }
  for (Vec3d& v : bodies.velocity) v -= momentum / mass;
}

std::vector<Vec3d> fcc_lattice(int cells, double edge) {
  std::vector<Vec3d> sites;
  for (int c = 0; c < cells * cells * cells; ++c) {
    const Vec3d corner(c % cells, c / cells % cells, c / cells / cells);
    for (const Vec3d& b : {Vec3d(0, 0, 0), Vec3d(0.5, 0.5, 0), Vec3d(0.5, 0, 0.5), Vec3d(0, 0.5, 0.5)}) {
      sites.push_back(edge * (corner + b + 0.25));
    }
  }
  return sites;
}

Scene equilibrium_gas(int cells, double rho, uint64_t seed, double collisions) {
  Scene scene = lattice_gas(cells, rho, seed);
  relax(scene, collisions / collision_rate(rho, static_cast<double>(scene.bodies.size())));
  return scene;
}

Scene equilibrium_mixture(int cells, uint64_t seed) {
  Scene scene = equilibrium_gas(cells, 0.5, seed);
  Bodies& bodies = scene.bodies;
  for (size_t i = 1; i < bodies.mass.size(); i += 2) {
    bodies.mass[i] = 0.2;
    bodies.radius[i] = 0.3;
  }
  stop_center(bodies);
  relax(scene, 40);
  return scene;
}

Scene equilibrium_column(uint64_t seed) {
  constexpr int kSide = 8, kLayers = 4;
  constexpr double kWidth = 20, kHeight = 40, kRadius = 0.1;
  Scene scene;
  scene.domain.max = {kWidth, kHeight, kWidth};
  scene.physics.gravity = {0, -1, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  for (int k = 0; k < kSide * kSide * kLayers; ++k) {
    const double height = kRadius + 0.5 * (k / (kSide * kSide) + 0.5);  // on average 1 above the lowest
    const Vec3d place((k % kSide + 0.5) * kWidth / kSide, height, (k / kSide % kSide + 0.5) * kWidth / kSide);
    put_sphere(scene, place, Vec3d(0.0), kRadius, 1);
  }
  Random random(seed);
  set_velocities(scene.bodies, random);
  relax(scene, 200);
  return scene;
}

Settings settings_of(const std::string& response, double dt, const std::string& integrator) {
  Settings settings;
  settings.response = named<Response>(response);
  settings.integrator = named<Integrator>(integrator);
  settings.precision = Precision::float64;
  settings.broadphase = BroadPhase::sorted_grid;
  settings.dt = dt;
  settings.threads = 1;
  return settings;
}

Settings exact_motion(double dt) {
  Settings settings = settings_of("event-driven", dt);
  settings.contact_duration = 0;
  return settings;
}

std::unique_ptr<World> make_world_on_cpu(const Scene& scene, const Settings& settings) {
  return cpu_backend().make_world(scene, settings);
}

void step_until(World& world, double time, double dt) {
  while (world.time() < time - dt / 2) {
    stop_if_interrupted();
    world.step();
  }
}

bool TimedRun::reach(double time) {
  const auto start = std::chrono::steady_clock::now();
  try {
    if (!has_stopped_) step_until(*world_, time, dt_);
  } catch (const RunError&) {
    has_stopped_ = true;
  }
  spent_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return !has_stopped_;
}

}  // namespace ballpit
