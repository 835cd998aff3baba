// SPDX-License-Identifier: MIT
// The acts of a run, applied to its world between two steps.
//
//     step   k          k+1         k+2          an act whose time lies after the end of step k, and not after the end of
//     ───────┼───────────┼───────────┼──▶        step k+1, belongs to step k+1: the state at the end of that step has it
//              ▲ act ───▶│
//
// So an act depends on its time alone, and a step that is computed again has its acts again, with the same bits. Bodies
// come and go through World::replace() in double precision, which holds single precision exactly.
#pragma once

#include <optional>
#include <vector>

#include "scene/acts.h"
#include "world/world.h"

namespace ballpit {

/// [m] From a to b, or in a periodic domain to b's nearest image.
double distance_in(const Domain& domain, const Vec3d& a, const Vec3d& b);

/// The bodies after an act. Throws RunError if a dropped sphere has no room, or if there is no such sphere.
Bodies acted(const Act& act, const Domain& domain, Bodies bodies);

class Acts {
 public:
  /// `acts` are in order of time.
  explicit Acts(const Domain& domain = {}, std::vector<Act> acts = {}) : domain_(domain), acts_(std::move(acts)) {}

  const std::vector<Act>& all() const { return acts_; }

  /// [s] The step of the world. Times that differ by a millionth of it are equal. Call for each new world.
  void steps_by(double dt) { tolerance_ = kRounding * dt; }

  /// Applies those of the world's present time or before. Call at the start of a run.
  bool begin(World& world);

  /// Steps the world, and applies the acts of the step. Returns whether there were any. Throws as World::step() and
  /// acted() do; then the step has no act.
  bool step(World& world);

  /// Acts on the world now, and forgets all acts that were to come. Throws as acted() does; then nothing changes.
  void add(Act act, World& world);

  /// How many acts take effect at or before `time` [s].
  int64_t count_until(double time) const;

  /// [J] of the world after the last act at or before `time` [s]; empty if there is none.
  std::optional<double> energy_after(double time) const;

 private:
  static constexpr double kRounding = 1e-6;  // of a step

  void apply(World& world, size_t first, size_t end);

  Domain domain_;
  std::vector<Act> acts_;
  std::vector<double> energy_;  // [J] after each of those that were applied so far
  double tolerance_ = 0;        // [s]
};

}  // namespace ballpit
