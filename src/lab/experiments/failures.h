// SPDX-License-Identifier: MIT
// What methods do where they fail: the numbers behind the maps of `stability`, one function a map's cell. The formulas that
// they are held against are in lab/theory.h.
#pragma once

#include <cstdint>
#include <vector>

namespace ballpit {

/// By which factor the fastest growing motion grows in a step [1]: an fcc crystal of 108 spheres (diameter 1 m, mass 1 kg), all
/// springs pressed a little, shaken a little, by velocity Verlet. At most 1 + 2 % where it is stable.
double spring_growth(double dt, double stiffness);
inline constexpr double kStableGrowth = 1.02;

/// The part of hits that are seen by contacts at the end of steps (or swept) of s diameters, at the impact parameter b/D: `phases`
/// pairs, each met at its own part of a step.
double part_of_hits_seen(double step, double impact, int phases, bool is_swept = false);

/// The part of `pairs` touching pairs, anywhere and in any direction, that linked cells of this edge (in diameters) find.
double recall_of_cells(double edge, int pairs, uint64_t seed);

/// The largest speed that so many sweeps of Gauss–Seidel leave in a step, as a part of gravity's kick, to spheres of these
/// masses at rest one upon the other.
double speed_left(const std::vector<double>& masses, int sweeps);

/// How far a sphere at x [m] moves in single precision at v·dt [m] a step, as a part of how far it should.
double part_of_way(double x, double step);

/// A bullet that flies `step` [m] in a step at a wall 0.2 m thick: whether it is behind the wall after all.
bool passes_through(double step, bool is_swept);

}  // namespace ballpit
