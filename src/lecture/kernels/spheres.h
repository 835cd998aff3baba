// SPDX-License-Identifier: MIT
// The test of two spheres, which all kernels share.
#pragma once

#include "bodies/bodies_view.h"
#include "bodies/box.h"

namespace ballpit::lecture {

template <class V>
struct Spheres {
  Span<const V> position;     ///< [m]
  PerBody<Scalar<V>> radius;  ///< [m]
  Box<V> box;

  HOST_DEVICE int size() const {
    return static_cast<int>(position.size());
  }

  HOST_DEVICE bool touch(int i, int j) const {
    return in_contact(box.displacement(position[i], position[j]),
                      radius[i] + radius[j]);
  }
};

}  // namespace ballpit::lecture
