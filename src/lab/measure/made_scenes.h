// SPDX-License-Identifier: MIT
// Scenes with known outcomes, made in code, and worlds on the CPU that run them on one thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "methods/settings.h"
#include "scene/scene.h"
#include "world/world.h"

namespace ballpit {

void add_sphere(Scene& scene, const Vec3d& position, const Vec3d& velocity, double radius, double mass);

/// A cube of this half edge about the origin, without gravity and losses.
Scene wide_box(double half = 50.0);

/// Two spheres of mass 1 and diameter 1 that approach head-on along x at `speed`, `gap` [m] apart.
Scene head_on(double speed, double gap);

/// Takes the velocity of the centre of mass from all.
void stop_center(Bodies& bodies);

/// Spheres of these masses and one radius at rest, one upon the other, on the floor; restitution 0.
Scene make_stack(const std::vector<double>& masses, double radius);

/// A gas of 4·cells³ hard spheres in a periodic cube at the number density rho; diameter, mass and kT = 2K/(3(N − 1)) are 1, the
/// total momentum is 0. It started as an fcc lattice and has since had so many collisions of each sphere, by exact motion. Forty are
/// too few beyond a density of 0.8: at 0.9 a lattice of 108 has not melted by then.
inline constexpr double kCollisionsToEquilibrium = 40;
Scene equilibrium_gas(int cells, double rho, uint64_t seed, double collisions = kCollisionsToEquilibrium);

/// Such a gas of density 0.5 whose every second sphere was made smaller and lighter, to three fifths of the diameter and a fifth of the
/// mass, and which moved exactly for 40 units of time after that. Its momentum is 0, its kT is not 1 any more.
Scene equilibrium_mixture(int cells, uint64_t seed);

/// A thin gas of 256 spheres under gravity, after nearly twenty collisions of each by exact motion: diameter 0.2, mass and gravity 1,
/// kT nearly 1, in a box of elastic walls whose top they hardly ever reach.
Scene equilibrium_column(uint64_t seed);

/// Settings of one thread in double precision.
Settings settings_of(const std::string& response, double dt, const std::string& integrator = "auto");

/// Settings of exact motion.
Settings exact_motion(double dt);

std::unique_ptr<World> make_cpu_world(const Scene& scene, const Settings& settings);

/// Steps until the time [s] is reached, to half a step. Throws Interrupted.
void step_until(World& world, double time, double dt);

}  // namespace ballpit
