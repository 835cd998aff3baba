// SPDX-License-Identifier: MIT
// The measurements behind the maps of `stability`: each function gives the value of one cell. Their formulas are in
// lab/measure/theory.h.
#pragma once

#include <cstdint>
#include <vector>

namespace ballpit {

/// The factor by which the fastest motion grows in a step of velocity Verlet: an fcc crystal of 108 spheres (diameter 1
/// m, mass 1 kg), slightly compressed and slightly displaced. At most 1.02 if it is stable.
double spring_growth(double dt, double stiffness);
inline constexpr double kStableGrowth = 1.02;

/// The part of hits that contacts at the ends of steps of s diameters (or swept contacts) find at the impact parameter
/// b/D: `phases` pairs, each hit at a different moment of a step.
double part_of_hits_seen(double step, double impact, int phases, bool is_swept = false);

/// The part of `pairs` touching pairs with random places and directions that linked cells of this edge [diameters]
/// find.
double recall_of_cells(double edge, int pairs, uint64_t seed);

/// The largest speed that this number of Gauss–Seidel sweeps leaves in a step, as a part of the speed that gravity
/// adds, for spheres of these masses at rest one on top of the other.
double speed_left(const std::vector<double>& masses, int sweeps);

/// The way of a sphere at x [m] in single precision with v·dt [m] per step, as a part of the exact way.
double part_of_way(double x, double step);

/// Whether a bullet that moves `step` [m] in a step passes through a wall of spheres 0.2 m thick.
bool passes_through(double step, bool is_swept);

}  // namespace ballpit
