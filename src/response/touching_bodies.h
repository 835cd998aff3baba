// SPDX-License-Identifier: MIT
// Copies of the bodies that touch something, for a response on the CPU. In a gas few bodies do. A loop over all bodies
// mispredicts a branch at most of those few, and the memory that it reads of them is spread among that of the others.
// Here the few are numbered, and what a response reads of them is copied. Contacts keep their numbers.
//
//     bodies      0 1 2 3 | 4 5 6 7      in blocks, so that each thread lists its own
//     touching    1 3     | 6            with numbers 0, 1 and 2
//     contacts    (1, 3) (3, 6)          between bodies
//                 (0, 1) (1, 2)          between their numbers
//
// On a GPU a thread finds out for itself whether its body touches something: the host does not know how many do.
#pragma once

#include <algorithm>
#include <utility>

#include "response/impulse_law.h"

namespace ballpit {

/// A block of bodies, begin … end − 1, and those of them that touch something: bodies[k] has number first + k.
struct TouchingBlock {
  static constexpr int kSize = 512;  ///< at most
  int begin, end, first;
  Span<const int> bodies;
};

/// Kernel: to[k] = from[body[k]].
template <class From, class T>
struct GatherValues {
  From from;
  Span<const int> body;
  Span<T> to;
  HOST_DEVICE void operator()(int k) const { to[k] = from[body[k]]; }
};

/// Kernel: contact c, and entry c of the lists of incoming contacts, between numbers.
struct NumberContact {
  Span<const int> number;  ///< of a body
  Span<const Pair> from_pairs;
  Span<const IncomingContact> from_incoming;
  Span<Pair> pairs;
  Span<IncomingContact> incoming;

  HOST_DEVICE void operator()(int c) const {
    pairs[c] = {number[from_pairs[c].i], number[from_pairs[c].j]};
    incoming[c] = {from_incoming[c].contact, number[from_incoming[c].body]};
  }
};

/// Kernel: the velocities of a block of bodies: those that are solved by number, and those after the kick of the others.
template <class V>
struct ScatterVelocities {
  KickedVelocity<V> kicked;
  Span<const V> solved;
  Span<V> out;

  void operator()(const TouchingBlock& block) const {
    for (int i = block.begin; i < block.end; ++i) out[i] = kicked[i];
    for (int k = 0; k < block.bodies.size(); ++k) out[block.bodies[k]] = solved[block.first + k];
  }
};

/// Kernel: stores the corrections of a block of bodies, which are computed by number.
template <class V>
struct ScatterCorrections {
  PositionCorrection<V> correction;
  Span<V> out;  ///< [m]

  void operator()(const TouchingBlock& block) const {
    for (int i = block.begin; i < block.end; ++i) out[i] = V{};
    for (int k = 0; k < block.bodies.size(); ++k) out[block.bodies[k]] = correction[block.first + k];
  }
};

/// Kernel: moves a block of bodies by their velocities, and in addition, as DriftCorrected does.
template <class V>
struct DriftBlock {
  static constexpr int kDim = kDimensions<V>;
  PositionCorrection<V> correction;  ///< computed by number
  Scalar<V> dt;
  Span<const V> velocity;
  Span<V> position;

  void operator()(const TouchingBlock& block) const {
    Scalar<V> more[TouchingBlock::kSize * kDim]{};
    for (int k = 0; k < block.bodies.size(); ++k) {
      const V moved = correction[block.first + k];
      for (int axis = 0; axis < kDim; ++axis) more[(block.bodies[k] - block.begin) * kDim + axis] = moved[axis];
    }
    const Span<const Scalar<V>> v = components(velocity);
    const Span<Scalar<V>> x = components(position);
    const int from = block.begin * kDim, to = block.end * kDim;
#pragma omp simd
    for (int k = from; k < to; ++k) x[k] = x[k] + v[k] * dt + more[k - from];
  }
};

template <class V, class Exec>
class TouchingBodies {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  /// Counts the shares of all bodies and lists those that have any.
  void find(Exec& exec, const CountShares<V>& count) {
    all_ = count.share.size();
    lists_.resize(all_);
    ends_.resize((all_ + TouchingBlock::kSize - 1) / TouchingBlock::kSize);
    exec.parallel_for_blocks("count shares", ends_.size(), [=, lists = lists_.span(), ends = ends_.span()](int64_t b) {
      const CountShares<V> own = count;  // a local copy, which no pointer can alias, as in CpuExecutor
      const auto [begin, end] = range_of(b, lists.size());
      int* const list = lists.data() + begin;
      int size = 0;
      for (int i = begin; i < end; ++i) {
        list[size] = i;
        size += own(i);
      }
      ends[b] = size;
    });
    count_ = 0;
    for (int& end : ends_.span()) end = count_ += end;
  }

  /// Whether they are so few that copies of them pay.
  bool are_few() const { return 2 * count_ < all_; }

  /// After find(): the same view of them alone, by their numbers.
  ImpulseView<V> view(Exec& exec, const ImpulseView<V>& all) {
    body_.resize(count_ + 1);
    number_.resize(all_);
    for_each_block(exec, "number touching", NumberBodies{body_.span(), number_.span()});
    body_.span()[count_] = static_cast<int>(all_);  // so that lists of contacts end
    const int64_t m = all.contacts.pairs.size();
    pairs_.resize(m);
    incoming_.resize(m);
    exec.parallel_for(
        "number touching", m,
        NumberContact{number_.span(), all.contacts.pairs, all.contacts.incoming, pairs_.span(), incoming_.span()});
    ImpulseView<V> view = all;
    view.bodies = {gather(exec, all.bodies.position, position_), gather(exec, all.bodies.velocity, velocity_),
                   gather(exec, all.bodies.radius, radius_), gather(exec, all.bodies.inverse_mass, inverse_mass_)};
    view.walls.sweep.way = gather(exec, all.walls.sweep.way, way_);
    view.walls.sweep.kick = gather(exec, all.walls.sweep.kick, kick_);
    view.walls.sweep.first = gather(exec, all.walls.sweep.first, first_time_);
    view.contacts.pairs = pairs_.span();
    view.contacts.incoming = incoming_.span();
    view.contacts.first = gather(exec, all.contacts.first, first_, count_ + 1);
    view.contacts.incoming_first = gather(exec, all.contacts.incoming_first, incoming_first_, count_ + 1);
    view.share = gather(exec, all.share, share_);
    return view;
  }

  /// After view(): the same of the velocities after a kick, which is often added to those of the view.
  KickedVelocity<V> kicked(Exec& exec, const ImpulseView<V>& all, const KickedVelocity<V>& velocity) {
    const bool is_known = velocity.velocity.data() == all.bodies.velocity.data();
    const Span<const V> values = is_known ? velocity_.span() : gather(exec, velocity.velocity, kicked_);
    return {values, velocity.change, velocity.is_kicked};
  }

  /// After view(): the bodies, by their numbers.
  Span<const int> bodies() const { return {body_.span().data(), count_}; }

  /// After find(): calls kernel(block) for each block of all bodies, in parallel.
  template <class Kernel>
  void for_each_block(Exec& exec, const char* name, const Kernel& kernel) const {
    exec.parallel_for_blocks(name, ends_.size(), [=, lists = lists_.span(), ends = ends_.span()](int64_t b) {
      const Kernel own = kernel;
      const auto [begin, end] = range_of(b, lists.size());
      const int first = b > 0 ? ends[b - 1] : 0;
      own(TouchingBlock{begin, end, first, {lists.data() + begin, ends[b] - first}});
    });
  }

  int64_t bytes() const {
    return lists_.bytes() + ends_.bytes() + body_.bytes() + number_.bytes() + position_.bytes() + velocity_.bytes() +
           kicked_.bytes() + radius_.bytes() + inverse_mass_.bytes() + share_.bytes() + way_.bytes() + kick_.bytes() +
           first_time_.bytes() + first_.bytes() + incoming_first_.bytes() + pairs_.bytes() + incoming_.bytes();
  }

 private:
  /// The bodies of block b among n: begin and end.
  static std::pair<int, int> range_of(int64_t b, int64_t n) {
    return {static_cast<int>(b * TouchingBlock::kSize), static_cast<int>(std::min(n, (b + 1) * TouchingBlock::kSize))};
  }

  struct NumberBodies {
    Span<int> body, number;
    void operator()(const TouchingBlock& block) const {
      for (int k = 0; k < block.bodies.size(); ++k) {
        body[block.first + k] = block.bodies[k];
        number[block.bodies[k]] = block.first + k;
      }
    }
  };

  /// Values of the first n in body_; by default of all that touch something. Empty if there are none.
  template <class T>
  Span<const T> gather(Exec& exec, Span<const T> from, Buffer<T>& to, int64_t n) {
    if (from.empty()) return {};
    to.resize(n);
    exec.parallel_for("gather touching", n, GatherValues<Span<const T>, T>{from, body_.span(), to.span()});
    return to.span();
  }
  template <class T>
  Span<const T> gather(Exec& exec, Span<const T> from, Buffer<T>& to) {
    return gather(exec, from, to, count_);
  }

  PerBody<Real> gather(Exec& exec, const PerBody<Real>& from, Buffer<Real>& to) {
    if (from.is_uniform()) return from;
    to.resize(count_);
    exec.parallel_for("gather touching", count_, GatherValues<PerBody<Real>, Real>{from, body_.span(), to.span()});
    return {to.span().data(), 1};
  }

  int64_t all_ = 0;
  int count_ = 0;
  Buffer<int> lists_;  // in each block, from its beginning on
  Buffer<int> ends_;   // of each block: how many there are up to its end
  Buffer<int> body_, number_;
  Buffer<V> position_, velocity_, kicked_, way_, kick_;
  Buffer<Real> radius_, inverse_mass_, share_, first_time_;
  Buffer<int> first_, incoming_first_;
  Buffer<Pair> pairs_;
  Buffer<IncomingContact> incoming_;
};

}  // namespace ballpit
