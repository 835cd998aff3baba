// SPDX-License-Identifier: MIT
// Follows a run from a moment on, for observables of the time since then: collisions, and the ways of spheres.
#pragma once

#include "world/observables.h"

namespace ballpit {

class Observer {
 public:
  /// Begins at the first moment that is not before `from` [s]. `follows_ways`: looks at all positions after each step,
  /// in which no sphere may move by more than half of a periodic domain.
  Observer(Domain domain, double from, bool follows_ways)
      : domain_(std::move(domain)), from_(from), follows_ways_(follows_ways) {}

  /// Call it at the start and after each step.
  void look(World& world);

  /// The present state, with time and tally since the beginning; those of an observation that has not begun are 0.
  Observation observation(World& world, const Report& report) const;

 private:
  void follow(const std::vector<Vec3d>& positions);

  Domain domain_;
  double from_;  // [s]
  bool follows_ways_, has_begun_ = false;
  double begin_ = 0;  // [s]
  Tally before_{};
  std::vector<Vec3d> last_, ways_;  // [m] the positions at the last look; how far each sphere has moved
};

}  // namespace ballpit
