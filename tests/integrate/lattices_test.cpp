// SPDX-License-Identifier: MIT
// The largest stable step of springs in lattices: dt_c = 2/ω_max, in units of √(m/k).
//
//     a pair           ω² = 2k/m         √2        both masses move: the reduced one is m/2
//     a long chain     ω² → 4k/m         1         neighbours move against each other
//     simple cubic     ω² = 4k/m         1         planes of atoms against each other, at the zone's corner
//     bcc, 8 springs   ω² = 16k/(3m)     √3/2      its two cubes against each other
//     fcc, 12 springs  ω² = 8k/m         1/√2      planes (001) against each other, at the zone's point X
//
// The frequencies follow from ω²·e = (k/m)·Σ_n n·(n·(1 − cos q·r_n))·e over the springs' directions n (Ashcroft and
// Mermin, "Solid State Physics" (1976), chapter 22).
#include <algorithm>
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "exec/cpu_executor.h"
#include "integrate/rk4.h"
#include "integrate/symplectic_euler.h"
#include "integrate/velocity_verlet.h"
#include "tests/support/hits.h"

using namespace ballpit;

namespace {

constexpr double kSqueeze = 1e-5;     // of a diameter: how far the spheres of a lattice overlap at rest
constexpr double kDisturbed = 1e-11;  // [m] from there: so little that a thousandfold growth breaks no contact

/// A periodic crystal of spheres of diameter 1 and mass 1 that overlap a little, so that the springs between them (k =
/// 1) may pull as well. `basis` and the neighbours' `distance` are in units of the cell's edge.
Scene crystal(const IVec3& cells, const std::vector<Vec3d>& basis, double distance, const Vec3d& stretch = Vec3d(1.0)) {
  const double edge = (1 - kSqueeze) / distance;
  Random random(5);
  Scene scene;
  scene.domain = {Vec3d(0.0), edge * Vec3d(cells) * stretch, Boundary::periodic, 3};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  scene.physics.stiffness = 1;
  for (int z = 0; z < cells.z; ++z) {
    for (int y = 0; y < cells.y; ++y) {
      for (int x = 0; x < cells.x; ++x) {
        for (const Vec3d& b : basis) {
          const Vec3d place = edge * (Vec3d(x, y, z) + b + 0.25);
          add_sphere(scene, place + kDisturbed * random.uniform(Vec3d(-1.0), Vec3d(1.0)), Vec3d(0.0), 0.5, 1.0);
        }
      }
    }
  }
  return scene;
}

/// Whether a crystal's spheres leave their positions within this many steps, by a thousand times their first
/// displacement.
bool grows(const Scene& scene, double dt) {
  Settings settings = settings_of("penalty", dt, "velocity-verlet");
  settings.max_energy = 1e15;
  const auto world = make_cpu_world(scene, settings);
  for (int k = 0; k < 200; ++k) {
    world->step();
    for (const Vec3d& v : world->bodies().velocity) {
      if (length(v) * dt > 1000 * kDisturbed) return true;
    }
  }
  return false;
}

struct Crystal {
  std::string name;
  Scene scene;
  int neighbours;
  double limit;
};

std::vector<Crystal> crystals() {
  const double s = std::sqrt(0.5);
  return {
      {"a chain", crystal({32, 1, 1}, {Vec3d(0.0)}, 1, {1, 4, 4}), 2, 1.0},
      {"simple cubic", crystal({4, 4, 4}, {Vec3d(0.0)}, 1), 6, 1.0},
      {"bcc", crystal({3, 3, 3}, {Vec3d(0.0), Vec3d(0.5)}, std::sqrt(0.75)), 8, std::sqrt(0.75)},
      {"fcc", crystal({3, 3, 3}, {Vec3d(0.0), {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}, s), 12, s},
  };
}

/// A free chain of masses 1 with springs (k = 1) that also pull: the parts of a world that integrators need.
struct Chain {
  CpuExecutor executor{1};
  HostBuffer<Vec2d> position, velocity;

  explicit Chain(int count) {
    Random random(5);
    const std::vector<Vec2d> still(static_cast<size_t>(count), Vec2d(0.0));
    std::vector<Vec2d> places = still;
    for (int i = 0; i < count; ++i) places[static_cast<size_t>(i)].x = i + kDisturbed * random.uniform(-1.0, 1.0);
    executor.upload(position, places);
    executor.upload(velocity, still);
  }

  CpuExecutor& exec() { return executor; }
  int64_t count() const { return position.size(); }
};

/// [m/s²]
void accelerate(const Chain& chain, Span<Vec2d> acceleration) {
  const Span<const Vec2d> x = chain.position.span();
  for (int i = 0; i < chain.count(); ++i) acceleration[i] = Vec2d(0.0);
  for (int i = 0; i + 1 < chain.count(); ++i) {
    const double stretch = x[i + 1].x - x[i].x - 1;
    acceleration[i].x += stretch;
    acceleration[i + 1].x -= stretch;
  }
}

/// A step, as the world makes it.
template <class ForceIntegrator>
void step(Chain& chain, ForceIntegrator& integrator, double dt) {
  for (int pass = integrator.first_pass(chain.count()); pass < ForceIntegrator::kPasses; ++pass) {
    integrator.before_forces(chain, dt, pass);
    accelerate(chain, integrator.acceleration(chain.count()));
    integrator.after_forces(chain, dt, pass);
  }
}

template <class Integrator>
bool chain_grows(int count, double dt) {
  Chain chain(count);
  Integrator integrator(false);
  for (int k = 0; k < 300; ++k) {
    step(chain, integrator, dt);
    for (int i = 0; i < count; ++i) {
      if (std::fabs(chain.velocity.span()[i].x) * dt > 1000 * kDisturbed) return true;
    }
  }
  return false;
}

template <class Integrator>
void check_chain(int count, double limit) {
  INFO(count << " masses, limit " << limit);
  CHECK_FALSE(chain_grows<Integrator>(count, 0.98 * limit));
  CHECK(chain_grows<Integrator>(count, 1.02 * limit));
}

}  // namespace

TEST_CASE("the crystals have the neighbours that their limits count on") {
  for (const Crystal& crystal : crystals()) {
    INFO(crystal.name);
    const auto world = make_cpu_world(crystal.scene, settings_of("penalty", 0.1));
    CHECK(2 * world->report().contacts == crystal.neighbours * crystal.scene.bodies.size());
  }
}

TEST_CASE("lattices of springs are stable below dt = 2/ω_max by velocity Verlet, and not above") {
  for (const Crystal& crystal : crystals()) {
    INFO(crystal.name << ", limit " << crystal.limit);
    CHECK_FALSE(grows(crystal.scene, 0.98 * crystal.limit));
    CHECK(grows(crystal.scene, 1.02 * crystal.limit));
  }
}

TEST_CASE("a free chain of n springs that pull, too, is stable below dt = 1/cos(π/2n), a pair below √2") {
  // ω_max = 2·√(k/m)·cos(π/2n) with free ends.
  for (const int count : {2, 3, 100}) {
    const double limit = 1 / std::cos(M_PI / (2 * count));
    check_chain<VelocityVerlet<Vec2d, CpuExecutor>>(count, limit);
    check_chain<SymplecticEuler<Vec2d, CpuExecutor>>(count, limit);
  }
}

TEST_CASE("by Runge-Kutta a pair is stable below dt = 2 and a long chain below √2: 2.828/ω_max") {
  check_chain<RungeKutta4<Vec2d, CpuExecutor>>(2, 2.0);
  check_chain<RungeKutta4<Vec2d, CpuExecutor>>(100, std::sqrt(2.0) / std::cos(M_PI / 200));
}
