// SPDX-License-Identifier: MIT
// Where a response records impulses.
#pragma once

#include "core/host_device.h"
#include "core/math.h"
#include "core/span.h"

namespace ballpit {

/// Where a response notes what it does, for a tally; empty spans where none is kept.
template <class V>
struct ImpulseNotes {
  Span<Scalar<V>> contact;  ///< [kg·m/s] exchanged by each contact
  Span<Scalar<V>> floor;    ///< [kg·m/s] given by each body to the wall at min.y

  HOST_DEVICE bool are_kept() const { return !floor.empty(); }
};

}  // namespace ballpit
