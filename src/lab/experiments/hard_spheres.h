// SPDX-License-Identifier: MIT
// What is measured of gases of hard spheres in a periodic box; diameter, mass and kT are 1. The values to hold it against are in
// lab/theory.h.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

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

/// Z_N = 1 + W/(3·N·kT·t) of each block, W the virial of its collisions, kT that of the block: so many collisions apart that blocks
/// are as good as independent. Each begins at kT = 1: many steps that change the energy a little would change what a step is.
std::vector<double> block_z(const GasRun& run, const Settings& settings);

/// The same of a gas in equilibrium that is given, for its physics to be chosen.
std::vector<double> block_z(const GasRun& run, const Settings& settings, const Scene& gas);

/// The steps of impulses at which late contacts are shown: without losses, by the solver that keeps a gas's energy best.
Settings elastic_impulses(double dt, bool is_swept);

/// T/T₀ at these times, in hundredths of Haff's τ and units of it, of one gas by exact motion.
std::vector<double> cooling(const GasRun& run, double restitution, const std::vector<double>& times);

}  // namespace ballpit
