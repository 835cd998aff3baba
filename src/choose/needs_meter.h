// SPDX-License-Identifier: MIT
// Measures a run against what its scene needs. One table has all tolerances; commands, tests and benchmarks use it.
#pragma once

#include <string>
#include <vector>

#include "world/observer.h"

namespace ballpit {

/// What a scene without [needs] gets; `note` says so, and is empty if the scene declares them.
struct EffectiveNeeds {
  Needs needs;
  std::string note;
};
EffectiveNeeds effective_needs(const Scene& scene);

/// One tolerance of a scene.
struct Tolerance {
  std::string name;  ///< as in [needs], or of an observable
  double allowed;
  bool grows;  ///< in proportion to time, so that a shorter run has a smaller error
};

/// In the order of the table; without those that the needs do not name.
std::vector<Tolerance> tolerances_of(const Needs& needs);

/// Throws UserError for an observable of [needs.observables] that does not exist.
void check_observables(const Needs& needs);

/// The true state at the end of a run, and the true values of the observables.
struct Truth {
  double time = 0;                         ///< [s]
  std::vector<Vec3d> position, velocity;   ///< [m], [m/s] empty: unknown
  std::vector<ObservedValue> observables;  ///< in the order of the needs; empty: unknown
};

class NeedsMeter {
 public:
  /// Call it at the start of the run. The world keeps a tally if observables need one. `seen_before`: as seen().
  NeedsMeter(const Scene& scene, Needs needs, World& world, double seen_before = 0);

  /// Call it after a step, for max_overlap_ever.
  void look(World& world);

  /// The largest overlap that look() has seen, as a fraction of the smaller radius.
  double seen() const { return seen_; }

  /// The present error of each of tolerances_of(needs); not a number where it takes a truth that is unknown.
  std::vector<double> errors(World& world, const Truth& truth) const;

  /// What a later run can be compared with.
  Truth truth(World& world) const;

 private:
  std::vector<ObservedValue> observables(World& world, const Report& report) const;

  Domain domain_;
  Needs needs_;
  Observer observer_;
  double bottom_energy_;  // [J] potential energy of all spheres at the bottom of the domain
  double energy_, momentum_scale_;
  Vec3d momentum_;
  double seen_;
  std::vector<double> radius_;

  friend struct NeedRow;
};

/// Whether an observable needs Settings::keeps_tally.
bool need_tally(const Needs& needs);

/// [J] kinetic, potential and elastic.
double energy_of(const Report& report);

/// RMS speed, weighted by mass [m/s].
double rms_speed(const Report& report, const Bodies& bodies);

}  // namespace ballpit
