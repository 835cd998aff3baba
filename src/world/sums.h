// SPDX-License-Identifier: MIT
// Sums over bodies and contacts, for reports and the guard: in double precision, in an order fixed by the indices.
#pragma once

#include <cmath>
#include <cstring>
#include <sstream>

#include "bodies/bodies_view.h"
#include "core/random.h"
#include "exec/reduce.h"
#include "world/world.h"

namespace ballpit {

/// Parts of a message as one text. Not by fmt, which nvcc 13 does not compile.
template <class... Parts>
std::string streamed(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

struct Largest {
  HOST_DEVICE double operator()(double a, double b) const { return a < b ? b : a; }
};

/// Map: the i-th value of an array.
template <class Real>
struct DoubleAt {
  Span<const Real> values;
  HOST_DEVICE double operator()(int i) const { return double(values[i]); }
};

/// Energy and momentum of one body, or of many.
struct EnergyAndMomentum {
  double kinetic = 0, potential = 0;
  Vec3d momentum{0.0};

  HOST_DEVICE EnergyAndMomentum operator+(const EnergyAndMomentum& other) const {
    return {kinetic + other.kinetic, potential + other.potential, momentum + other.momentum};
  }
};

template <class V>
struct EnergyAndMomentumOf {
  BodiesView<V> bodies;
  V gravity;
  V zero{};  ///< [m] where potential energy is 0

  HOST_DEVICE EnergyAndMomentum operator()(int i) const {
    const double mass = 1.0 / double(bodies.inverse_mass[i]);
    const V v = bodies.velocity[i], x = bodies.position[i];
    double squared = 0, height = 0;
    Vec3d momentum(0.0);
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      squared += double(v[axis]) * double(v[axis]);
      height -= double(gravity[axis]) * (double(x[axis]) - double(zero[axis]));
      momentum[axis] = mass * double(v[axis]);
    }
    return {0.5 * mass * squared, mass * height, momentum};
  }
};

/// Map: how much pair k overlaps, as a fraction of the smaller radius; −1 where they do not touch.
template <class V>
struct PairOverlap {
  BodiesView<V> bodies;
  Box<V> box;
  Span<const Pair> pairs;

  HOST_DEVICE double operator()(int k) const {
    const Pair pair = pairs[k];
    const V d = box.displacement(bodies.position[pair.i], bodies.position[pair.j]);
    if (!in_contact(d, bodies.radius[pair.i] + bodies.radius[pair.j])) return -1;
    const double ri = double(bodies.radius[pair.i]), rj = double(bodies.radius[pair.j]);
    return (ri + rj - std::sqrt(double(dot(d, d)))) / (ri < rj ? ri : rj);
  }
};

template <class V>
struct WallOverlap {
  BodiesView<V> bodies;
  Box<V> box;

  HOST_DEVICE double operator()(int i) const {
    double largest = 0;
    box.for_each_wall(bodies.position[i], bodies.radius[i], [&](int, int, Scalar<V> overlap) {
      const double fraction = double(overlap) / double(bodies.radius[i]);
      if (fraction > largest) largest = fraction;
    });
    return largest;
  }
};

/// The largest overlap of two spheres, or of a sphere and a wall, as a fraction of the smaller radius.
template <class V, class Exec>
double largest_overlap(Exec& exec, const char* name, const BodiesView<V>& bodies, const Box<V>& box,
                       Span<const Pair> pairs) {
  const double spheres = reduce(exec, name, pairs.size(), 0.0, PairOverlap<V>{bodies, box, pairs}, Largest{});
  const double walls = reduce(exec, name, bodies.size(), 0.0, WallOverlap<V>{bodies, box}, Largest{});
  return spheres < walls ? walls : spheres;
}

/// Predicate: body i is outside the domain or not finite.
template <class V>
struct IsOutside {
  BodiesView<V> bodies;
  Box<V> box;

  HOST_DEVICE bool operator()(int i) const {
    const V& v = bodies.velocity[i];
    return !(box.holds(bodies.position[i]) & (dot(v, v) < Scalar<V>(1e30)));  // false for NaN
  }
};

/// A hash of the bits of body `id`. The sum over all bodies, in any order, is the hash of the state.
template <class V>
HOST_DEVICE uint64_t hash_body(int64_t id, const V& position, const V& velocity) {
  uint64_t hash = mix_bits(static_cast<uint64_t>(id) + 0x9E3779B97F4A7C15u);
  for (const V& v : {position, velocity}) {
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      uint64_t bits = 0;
      std::memcpy(&bits, &v[axis], sizeof(v[axis]));
      hash = mix_bits(hash ^ bits);
    }
  }
  return hash;
}

/// Map: the hash of the body in a slot.
template <class V>
struct HashOfBody {
  BodiesView<V> bodies;
  Span<const int> id_at;

  HOST_DEVICE uint64_t operator()(int place) const {
    return hash_body(id_at.empty() ? place : id_at[place], bodies.position[place], bodies.velocity[place]);
  }
};

}  // namespace ballpit
