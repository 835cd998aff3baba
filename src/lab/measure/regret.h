// SPDX-License-Identifier: MIT
// Judges a choice: does it hold the needs of its scene in a full run, and what does it cost against the cheapest of a
// wide grid of options that holds them?
//
//     grid: methods × iterations × integrators × steps, each half as long as the one before
//           × broad phases × skins × one thread or all, for the best of these
//
// A point of the grid holds if the next finer step of its method holds as well, so that luck is not compared with. Runs
// that cost less than 10 ms count as equal.
#pragma once

#include "choose/choose.h"

namespace ballpit {

struct FullRun {
  bool holds = false;
  double seconds = 0;    ///< [s] of computing
  std::string why = {};  ///< what is broken, or why the run was stopped
};

/// A run of the whole scene for its needs' duration; it is given up after `limit` [s] of computing.
FullRun full_run(const Scene& scene, const Needs& needs, const Truth& truth, const Settings& settings, double limit);

/// The true course of the whole scene where the needs ask for one: by exact motion, or by springs of very short steps.
Truth full_truth(const Scene& scene, const Needs& needs);

struct Judged {
  std::string family;
  int64_t count = 0;                           ///< spheres
  bool has_choice = false, has_valid = false;  ///< something was chosen; something in the grid holds
  bool holds = false;                          ///< the choice, in a full run
  std::string method{}, best_method{};
  double cost = 0, best_cost = 0;  ///< [s] of computing, medians of five
  double chosen_in = 0;            ///< [s] that the choice took
  std::string why = {};

  /// The cost by that of the cheapest, each at least 10 ms; infinite if nothing was chosen although something holds.
  double regret() const;
};

/// The methods that a Judged can name: the variants that `choose` knows, and the lines of the grid.
std::vector<std::string> judged_methods();

Judged judge(std::string_view family, const Scene& scene, double budget = 5);

}  // namespace ballpit
