// SPDX-License-Identifier: MIT
// Writes bodies for the vertex shader, in the order of their ids, on the processor that simulates them. If that processor also
// draws, no position leaves its memory.
#pragma once

#include "bodies/bodies_view.h"
#include "bodies/body_snapshot.h"
#include "bodies/pair.h"
#include "core/span.h"
#include "exec/atomics.h"
#include "world/body_store.h"

namespace ballpit {

template <class V>
HOST_DEVICE void write_body(const BodyTarget& target, int64_t id, const V& position, double radius) {
  constexpr int d = kDimensions<V>;
  for (int axis = 0; axis < d; ++axis) target.position[id * d + axis] = static_cast<float>(position[axis]);
  if (!target.radius.empty()) target.radius[id] = static_cast<float>(radius);
}

/// Kernel: the bodies of pair k touch.
struct NoteTouching {
  Span<const Pair> pairs;
  Span<int> touching;  // by slot
  HOST_DEVICE void operator()(int k) const {
    atomic_exchange(&touching[pairs[k].i], 1);
    atomic_exchange(&touching[pairs[k].j], 1);
  }
};

/// Kernel: writes the body in a slot.
template <class V>
struct WriteBody {
  BodiesView<V> bodies;
  Span<const int> id_at, touching;
  BodyTarget target;

  HOST_DEVICE void operator()(int slot) const {
    const int id = id_at.empty() ? slot : id_at[slot];
    write_body(target, id, bodies.position[slot], double(bodies.radius[slot]));
    target.touching[id] = static_cast<uint8_t>(touching[slot]);
  }
};

/// `pairs` are in contact.
template <class V, class Exec>
void write_bodies(const BodyStore<V, Exec>& bodies, Span<const Pair> pairs, const BodyTarget& target) {
  Exec& exec = bodies.exec();
  const Span<int> touching = exec.template scratch<int>(0, bodies.count());
  exec.fill("write bodies", touching, 0);
  exec.parallel_for("write bodies", pairs.size(), NoteTouching{pairs, touching});
  exec.parallel_for("write bodies", bodies.count(),
                    WriteBody<V>{bodies.view(), bodies.order().id_at(), touching, target});
}

}  // namespace ballpit
