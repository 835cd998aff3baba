// SPDX-License-Identifier: MIT
// The exact ghost: event-driven motion that runs beside a stepped world from the same state, and how far they are
// apart.
//
//     dropped            now
//        ├────┬────┬────┬─┤   each step: the stepped world's state, until the first wrong collision is found
//        ●    ●    ●    ● ○   distances: of every step at first; when there are kMaxSamples, every second one is
//                             dropped, so that those of every 2nd, 4th, … are left. ○: the present one, for a picture
//
// Cost: that of event-driven motion, and a fiftieth more for the distances. Until the first wrong collision is found,
// which takes a step or two in a gas, also a look at all spheres in each step, a fifth of what a stepped world's step
// costs. States that lie back are computed again (world/exact_motion.h); distances of steps that were seen before are
// remembered.
//
// A stepped state may have spheres that overlap. Such a pair collides at once if it approaches, and parts freely if not
// (event_driven/flight.h). Deeper overlap than kMaxOverlap is refused, and so is a motion with endless collisions.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "world/collision_watch.h"
#include "world/exact_motion.h"
#include "world/ghost_inspection.h"
#include "world/world.h"

namespace ballpit {

/// Lyapunov's exponent of a gas of equal hard spheres in e-folds for each collision of a sphere, by its density N·d³/V:
/// the distance of neighbouring states grows by e to this power while each sphere collides once. Empty outside of 0.05
/// to 0.7. Measured here by two event-driven runs that rounding parts, 500 to 1 372 spheres, ±4 %: 3.95 at 0.05, 2.6 at
/// 0.1, 1.65 at 0.2, 1.2 at 0.3, 0.8 at 0.5, 0.53 at 0.7; in between linear in the logarithm of the density, as thin
/// gases have it: van Zon, van Beijeren, Dellago, "Largest Lyapunov exponent for many particle systems at low
/// densities" (1998), doi 10.1103/PhysRevLett.80.2035.
std::optional<double> e_folds_per_collision(double density);

class Ghost {
 public:
  static constexpr size_t kMaxSamples = 512;
  static constexpr double kMaxOverlap = 0.5;  ///< of the smaller radius, of the state it begins with

  /// Begins from the world's present state, at `time` [s]. Of the scene it takes domain and physics.
  Ghost(const Scene& scene, const Settings& settings, World& world, double time);

  /// The world has made a step of `dt` [s] that ends at `time` [s]. Steps seen before cost nothing. After steps that
  /// were left out, the search for the first wrong collision ends.
  void follow(World& world, double time, double dt);

  /// What follows after `time` will be another motion of the stepped world.
  void forget_after(double time);

  /// [s] The end of the latest step that was seen.
  double seen() const { return seen_; }

  /// The ghost beside the world's present state, at `time` [s].
  GhostInspection inspect(World& world, double time, double dt, bool is_exact);

 private:
  bool go_to(double time, double dt, std::vector<LoggedCollision>* log = nullptr);
  GhostDistance distance_at(double time, const std::vector<double>& radius);
  void keep(const GhostDistance& distance);
  void add_growth(GhostInspection& seen, double time) const;

  Domain domain_;
  double dropped_, seen_;  // [s]
  double overlap_ = 0;
  double density_ = 0;                   // N·d³/V of a gas whose exponent is known; 0 for others
  std::unique_ptr<ExactMotion> motion_;  // none if the state is refused
  std::string_view lack_;
  double lacks_from_ = 0;                              // [s] from when on
  std::optional<CollisionWatch> fresh_watch_, watch_;  // at the start; none after steps that were left out
  std::vector<GhostDistance> samples_;
  int64_t steps_ = 0, stride_ = 1;  // steps seen; from one sample to the next
  double sampled_ = 0;              // events at the latest sample
  int64_t count_ = 0;               // of spheres
  Lead lead_;                       // kept for its memory, as is
  std::vector<double> distance_;    // [radii]
};

}  // namespace ballpit
