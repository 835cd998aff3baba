// SPDX-License-Identifier: MIT
// When and where bodies meet in a swept step (swept.h).
#pragma once

#include <cmath>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/contacts.h"

namespace ballpit {

/// When and how two bodies meet.
template <class V>
struct Impact {
  Scalar<V> time;  ///< as a fraction of the step; above 1: not in this one
  V apart;         ///< from i to j, then [m]
};

/// The first time in the step at which two bodies touch.
template <class V>
struct FindImpact {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  Box<V> box;
  Span<const V> way, middle;

  HOST_DEVICE Impact<V> operator()(const Pair& pair) const {
    const V w = way[pair.j] - way[pair.i];
    const V d = box.displacement(middle[pair.i], middle[pair.j]) - w / Real(2);  // the images that meet
    const Real radii = bodies.radius[pair.i] + bodies.radius[pair.j];
    const Real c = dot(d, d) - radii * radii;
    if (c <= 0) return {Real(0), d};
    const Real a = dot(w, w), b = dot(d, w), root = b * b - a * c;
    if (!(b < 0) || root < 0) return {Real(2), d};
    const Real t = c / (-b + std::sqrt(root));
    return {t, d + w * t};
  }
};

/// Kernel: 1 for pairs that meet in the step.
template <class V>
struct MarkImpact {
  FindImpact<V> find;
  Span<const Pair> pairs;
  Span<int> is_hit;
  HOST_DEVICE void operator()(int k) const { is_hit[k] = find(pairs[k]).time <= 1; }
};

/// Kernel: keeps the pairs that are marked, in their order.
struct KeepMarked {
  Span<const Pair> pairs;
  Span<const int> place;  ///< one more than pairs
  Span<Pair> kept;
  HOST_DEVICE void operator()(int k) const {
    if (place[k + 1] > place[k]) kept[place[k]] = pairs[k];
  }
};

/// Kernel: where the kept pairs of body i begin.
struct KeepRows {
  Span<const int> first, place;
  Span<int> kept;
  HOST_DEVICE void operator()(int i) const { kept[i] = place[first[i]]; }
};

/// Kernel: contact c as it is when its bodies meet.
template <class V>
struct MeasureImpact {
  using Real = Scalar<V>;
  FindImpact<V> find;
  Span<const V> kick;
  Span<const Pair> pairs;
  Span<ContactGeometry<V>> geometry;
  Span<Real> time;

  HOST_DEVICE void operator()(int c) const {
    const Pair pair = pairs[c];
    const Impact<V> impact = find(pair);
    time[c] = impact.time;
    if (impact.time <= 0) return;  // they overlap already; measured by MeasureContact
    const V normal = impact.apart / std::sqrt(dot(impact.apart, impact.apart));
    V parting = find.bodies.velocity[pair.j] - find.bodies.velocity[pair.i];
    if (!kick.empty()) parting += (kick[pair.j] - kick[pair.i]) * impact.time;
    geometry[c] = {normal, Real(0), dot(parting, normal)};
  }
};

/// When a sphere of this radius at p meets a wall on its way, as a fraction of the step.
template <class V>
HOST_DEVICE Scalar<V> time_of_wall(const Box<V>& box, const V& p, const V& way, Scalar<V> radius, int axis, int side) {
  const Scalar<V> gap = (side < 0 ? p[axis] - box.min[axis] : box.max[axis] - p[axis]) - radius;
  return gap <= 0 ? Scalar<V>(0) : gap / std::fabs(way[axis]);
}

/// Kernel: when body i meets its first contact.
template <class V>
struct FindFirst {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  Box<V> box;
  ContactsView<V> contacts;
  Span<const V> way;
  Span<const Real> time;  ///< of each contact
  Span<Real> first;

  HOST_DEVICE void operator()(int i) const {
    const V p = bodies.position[i];
    const Real radius = bodies.radius[i];
    Real earliest = 1;
    contacts.for_each_of(i, [&](int c, int, int) {
      if (time[c] < earliest) earliest = time[c];
    });
    box.for_each_wall_on_way(p, p + way[i], radius, [&](int axis, int side, Real) {
      const Real met = time_of_wall(box, p, way[i], radius, axis, side);
      if (met < earliest) earliest = met;
    });
    first[i] = earliest;
  }
};

}  // namespace ballpit
