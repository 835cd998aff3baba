// SPDX-License-Identifier: MIT
// Scenes made in code whose outcome is known, and worlds that run them on one thread of the CPU.
#pragma once

#include <algorithm>

#include "methods/settings.h"
#include "scene/scene.h"
#include "world/world.h"

namespace ballpit {

void put_sphere(Scene& scene, const Vec3d& position, const Vec3d& velocity, double radius, double mass);

/// A cube around the origin with this half edge, without gravity and losses.
Scene wide_box(double half = 50.0);

/// Subtracts the velocity of the centre of mass from all velocities.
void stop_center(Bodies& bodies);

/// Spheres of these masses and equal radius at rest on the floor, one on top of the other; restitution 0.
Scene make_stack(const std::vector<double>& masses, double radius);

/// The corners of an fcc lattice of cells³ cubic cells with this edge, four in each.
std::vector<Vec3d> fcc_lattice(int cells, double edge);

/// A gas of 4·cells³ hard spheres in a periodic cube with the number density rho; diameter, mass and kT = 2K/(3(N − 1))
/// are 1, the total momentum is 0. It starts as an fcc lattice and moves exactly for this number of collisions per
/// sphere. Forty are too few for densities above 0.8: at 0.9 a lattice of 108 spheres has not melted by then.
inline constexpr double kCollisionsToEquilibrium = 40;
Scene equilibrium_gas(int cells, double rho, uint64_t seed, double collisions = kCollisionsToEquilibrium);

/// Such a gas of density 0.5, in which every second sphere is reduced to three fifths of the diameter and a fifth of
/// the mass, after 40 more units of time by exact motion. Its momentum is 0, but its kT is no longer 1.
Scene equilibrium_mixture(int cells, uint64_t seed);

/// A thin gas of 256 spheres under gravity, after nearly twenty collisions per sphere by exact motion: diameter 0.2,
/// mass and gravity 1, kT nearly 1, in a box with elastic walls whose top they hardly ever reach.
Scene equilibrium_column(uint64_t seed);

/// One thread in double precision.
Settings settings_of(const std::string& response, double dt, const std::string& integrator = "auto");

/// Exact motion, reported in steps of dt.
Settings exact_motion(double dt);

std::unique_ptr<World> make_world_on_cpu(const Scene& scene, const Settings& settings);

/// Steps until the time [s] is reached to within half a step. Throws Interrupted.
void step_until(World& world, double time, double dt);

/// A world on the CPU whose steps are timed. Its failure is a result, not an error.
class TimedRun {
 public:
  TimedRun(const Scene& scene, const Settings& settings)
      : world_(make_world_on_cpu(scene, settings)), dt_(settings.dt) {}

  /// Steps until `time` [s]; false if the run stops before.
  bool reach(double time);

  /// Computation time [s] per simulated second.
  double seconds() const { return spent_ / std::max(world_->time(), dt_); }

  double spent() const { return spent_; }  ///< computation time [s]

  World& world() { return *world_; }

 private:
  std::unique_ptr<World> world_;
  double dt_;
  double spent_ = 0;
  bool has_stopped_ = false;
};

}  // namespace ballpit
