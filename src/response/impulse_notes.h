// SPDX-License-Identifier: MIT
// Arrays in which a response records impulses.
#pragma once

#include "core/host_device.h"
#include "core/math.h"
#include "core/span.h"

namespace ballpit {

/// The impulses that a response applies, noted for a tally; empty spans if no tally is kept.
template <class V>
struct ImpulseNotes {
  Span<Scalar<V>> contact;  ///< [kg·m/s] of each contact
  Span<Scalar<V>> floor;    ///< [kg·m/s] of each body on the wall at min.y

  HOST_DEVICE bool are_kept() const { return !floor.empty(); }
};

}  // namespace ballpit
