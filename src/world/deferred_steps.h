// SPDX-License-Identifier: MIT
// Which steps of a world need not be waited for (exec/deferred.h), and what it takes to repeat them.
//
//     step     0 ── 1 ── 2 ── … ── 15 ── 16 ── 17 ── …       16: the guard checks and keeps a good state; the host waits
//     waits    ×    ×    –         –     ×     –
//
// A deferred step may halt the device: there are more contacts than room for them, or a body has left the domain. Then all
// later kernels do nothing. The host goes back to the last good state and makes the steps from there one by one, with
// more room, or up to the error. A step follows from the state alone, so the bits are the same.
#pragma once

#include <optional>

#include "world/step.h"

namespace ballpit {

template <class V, class Exec>
class DeferredSteps {
 public:
  /// Whether the next step, of this number, may be deferred.
  bool may_defer(const WorldParts<V, Exec>& world, int64_t step) const {
    return good_step_ && world.motion->can_repeat() && !world.tally.is_kept() && !world.guard.is_due(step) &&
           !world.bodies.order().is_due(step - 1);
  }

  /// The present state, after this step, is the guard's last good one.
  void note_good(const WorldParts<V, Exec>& world, int64_t step) {
    good_step_ = step;
    searches_ = world.collider.searches_so_far();
    substeps_ = world.motion->substeps();
  }

  /// The state is another one.
  void forget() { good_step_.reset(); }

  /// Goes back to the last good state; returns its step.
  int64_t go_back(WorldParts<V, Exec>& world) const {
    world.bodies.exec().go_on();
    world.guard.go_back(world.bodies, world.motion->kept());
    world.motion->go_back(substeps_);
    world.collider.discard(searches_);
    return *good_step_;
  }

 private:
  // And what had been made until then
  std::optional<int64_t> good_step_;
  typename Collider<V, Exec>::Searches searches_;
  int64_t substeps_ = 0;
};

}  // namespace ballpit
