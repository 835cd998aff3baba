// SPDX-License-Identifier: MIT
// A view of the bodies for kernels. V is Vec2 in planar scenes and Vec3 otherwise. The stages of a step exchange their
// data by this view and that of contacts.h:
//
//     position, velocity ──broad phase──▶ candidates ──narrow phase──▶ contacts ──response──▶ velocity ──▶ position
#pragma once

#include "core/math.h"
#include "core/span.h"

namespace ballpit {

template <class V>
struct BodiesView {
  Span<const V> position;           ///< [m]
  Span<const V> velocity;           ///< [m/s]
  PerBody<Scalar<V>> radius;        ///< [m]
  PerBody<Scalar<V>> inverse_mass;  ///< [1/kg]

  HOST_DEVICE int64_t size() const { return position.size(); }
};

/// Kernel: to = from.
template <class T>
struct CopyValues {
  static constexpr bool kIsElementwise = true;
  Span<const T> from;
  Span<T> to;
  HOST_DEVICE void operator()(int i) const { to[i] = from[i]; }
};

/// Velocities, after a kick that is added where they are read: so no kernel stores them.
template <class V>
struct KickedVelocity {
  Span<const V> velocity;  ///< [m/s]
  V change{};              ///< [m/s]
  bool is_kicked = false;  ///< without a kick the bits of zeros stay

  HOST_DEVICE const V* data() const { return velocity.data(); }  ///< what is read
  HOST_DEVICE V operator[](int64_t i) const { return is_kicked ? velocity[i] + change : velocity[i]; }
};

}  // namespace ballpit
