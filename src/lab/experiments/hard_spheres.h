// SPDX-License-Identifier: MIT
// Measurements of gases of hard spheres in a periodic box; diameter, mass and kT are 1. The expected values are in
// lab/measure/theory.h.
#pragma once

#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit {

/// A gas in equilibrium, observed for `blocks` blocks of `collisions` collisions per sphere each.
struct GasRun {
  int cells;  ///< 4·cells³ spheres
  double rho;
  uint64_t seed;
  int blocks;
  double collisions;
};

double count_of(const GasRun& run);  ///< spheres

/// Z_N = 1 + W/(3·N·kT·t) of each block, with the virial W of its collisions and its kT. Blocks are so long that they
/// are practically independent. Each starts at kT = 1, so that a slow change of energy does not change the meaning of
/// dt.
std::vector<double> block_z(const GasRun& run, const Settings& settings);

/// The same for a given gas in equilibrium, whose physics can be changed.
std::vector<double> block_z(const GasRun& run, const Settings& settings, const Scene& gas);

/// Impulses without losses, with the solver that keeps the energy of a gas best.
Settings elastic_impulses(double dt, bool is_swept);

/// T/T₀ of one gas by exact motion at these times [τ of Haff's law], which are multiples of 0.01.
std::vector<double> cooling(const GasRun& run, double restitution, const std::vector<double>& times);

}  // namespace ballpit
