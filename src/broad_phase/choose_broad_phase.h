// SPDX-License-Identifier: MIT
// --broadphase auto: the method with the shortest predicted time, and the predictions as the reason.
#pragma once

#include <string>

#include "bodies/box.h"
#include "broad_phase/parameters.h"
#include "core/span.h"
#include "methods/settings.h"

namespace ballpit {

struct BroadPhaseChoice {
  BroadPhase method;  ///< never automatic
  std::string reason;  ///< "predicted for 20000 spheres, ms on one core: sorted-grid 1.3, …"; empty if it was asked for
};

/// The broad phase that `settings` ask for; for "auto" the one predicted to be fastest on spheres spread evenly.
template <class V>
BroadPhaseChoice choose_broad_phase(const Settings& settings, const BroadPhaseParameters<V>& parameters);

/// The parameters for a box, settings and radii (one for all, or one each).
template <class V>
BroadPhaseParameters<V> broad_phase_parameters(const Settings& settings, const Box<V>& box,
                                               Span<const Scalar<V>> radius, int64_t count);

}  // namespace ballpit
