// SPDX-License-Identifier: MIT
// What the files of the experiments include: charts, tables, texts; the entry of each in the table, defined in the file
// of the same name; and formulas and measurements that experiments share and tests check.
#pragma once

#include <algorithm>

#include <fmt/format.h>

#include "core/numbers.h"
#include "core/phrase.h"
#include "lab/charts/chart.h"
#include "lab/measure/searches.h"
#include "lab/report/experiment.h"

namespace ballpit {

Experiment scaling_experiment();
Experiment cell_size_experiment();
Experiment size_ratio_experiment();
Experiment density_experiment();
Experiment axis_experiment();
Experiment divergence_experiment();
Experiment tuning_experiment();
Experiment crossover_experiment();
Experiment choice_experiment();
Experiment cooling_experiment();
Experiment drift_experiment();
Experiment equation_of_state_experiment();
Experiment far_origin_experiment();
Experiment pi_experiment();
Experiment substeps_experiment();
Experiment stability_experiment();
Experiment work_precision_experiment();

/// The paragraphs of assets/lab/NAME.md, or NAME.de.md, each on one line, without the marks of titles and quotations.
std::vector<std::string> paragraphs_of(std::string_view name);

/// The expected number of overlapping pairs among `count` intervals of length 1 whose middles are uniform along a
/// length L: n(n−1)/2 · (2/L − 1/L²); all pairs if L is less than 1.
double expected_interval_overlaps(int64_t count, double length);

/// The share of at least one contact that cells of this edge are expected to find in a 3 × 3 × 3 block: the mean over
/// pairs of Π clamp(2 − |d_k|/edge, 0, 1) over the axes k.
double expected_recall(const SphereSet& spheres, const std::vector<Pair>& contacts, double edge);

/// The standard error of a share found among this number of independent pairs.
double recall_error(double recall, size_t contacts);

/// The error of the pressure of a gas at a step.
struct PressureError {
  double dt;
  Mean off;  ///< Z/Z_N − 1; NaN if the run stopped
};

/// The coarser of the last two steps if both are within the tolerance of `crossover`; else 0. Errors are sorted by
/// step, coarsest first.
double largest_step(const std::vector<PressureError>& errors);

// Gases of hard spheres in a periodic box; diameter, mass and kT are 1. Their theory is in measure/theory.h.

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

// Galperin's billiard: a light ball between a wall and a ball that is `ratio` times as heavy, without losses.

/// Their collisions and hits of the wall together: ⌈π/atan(√(1/R))⌉ − 1, which is ⌊π·√R⌋ for R = 100^k.
double exact_collisions(double ratio);

/// [s] gap/R: how long after each other hits come where the heavy ball turns.
double safe_step(double ratio);

/// [s] radius/√R: how long the light ball needs there for a radius.
double leaving_step(double ratio);

/// As counted with these settings; infinite if the run stops. Springs have the stiffness whose contacts last 20 steps.
double collisions_counted(Settings settings, double ratio);

// The same work as n iterations in a step of dt [s], or as n substeps with one iteration each.

Settings equal_work(const std::string& response, double dt, int work, bool is_substeps);

/// The largest overlap, as a fraction of the radius, after three seconds of spheres that lie one upon the other;
/// infinite if the run stops.
double overlap_at_rest(const std::vector<double>& masses, const Settings& settings);

/// A stack of ten discs and a heap of a hundred that have settled at (x, −0.8·x). Both are fractions of the radius, and
/// infinite if the run stops.
struct FarHeaps {
  double height_error;  ///< of the stack's centre of mass above the floor, against the origin in double precision
  double overlap;       ///< the largest in the heap

  bool fails() const { return !(height_error <= 0.1 && overlap <= 0.1); }
};

FarHeaps heaps_at(double x, const Settings& settings);

// The change of energy and momentum, which should stay constant, in long runs.

/// Largest changes up to a time, relative to the start.
struct LargestDrift {
  double energy = 0;    ///< |E − E₀|/E₀
  double momentum = 0;  ///< |P − P₀|/Σ m·|v|
};

/// Up to each of these ascending times, checked every few steps. Infinite from the time at which a run stops.
std::vector<LargestDrift> drift_of(const Scene& scene, const Settings& settings, const std::vector<double>& times);

/// The largest |E/E₀ − 1| within 1, 2, 4, … 2^(count − 1) steps of a mass on a spring, which is a sphere on the floor
/// with the penalty response; omega_dt = ω·dt.
std::vector<double> oscillator_drift(const std::string& integrator, double omega_dt, int count);

/// The same by theory, z = ω·dt: (1 + z²)^n − 1 for explicit Euler, 1 − (1 − z⁶/72 + z⁸/576)^n for Runge–Kutta, and the
/// bounds z²/4 for velocity Verlet and z/(2 − z) for symplectic Euler.
double oscillator_theory(const std::string& integrator, double omega_dt, double steps);

/// The sphere leaves the floor when its energy exceeds this multiple of its energy at the start.
inline constexpr double kOscillatorLeaves = 100;

}  // namespace ballpit
