// SPDX-License-Identifier: MIT
// A queue of one time per sphere: a knock-out tournament, whose winner is the earliest.
//
//                  (1) 0.2 s, sphere 2
//            (2) 0.3, 1        (3) 0.2, 2          node k plays the winners of nodes 2k and 2k + 1
//         (4) 0.7, 0  (5) 0.3, 1  (6) 0.2, 2  (7) ∞
//
// When a sphere's time changes, its matches are played again, from its leaf upwards, until one ends as before. Of equal
// times the left one wins, which has the lower index, so simultaneous events have a fixed order.
// Cost: at most log₂ n matches, each in one cache line; 32 bytes a sphere, up to 64 if n is not a power of two.
// Source: Knuth, The Art of Computer Programming, vol. 3, section 5.4.1; for molecular dynamics Marín, Cordero, "An
// empirical assessment of priority queues in event-driven molecular dynamics simulation" (1995),
// doi 10.1016/0010-4655(95)00120-2.
#pragma once

#include <vector>

#include "event_driven/flight.h"

namespace ballpit {

class Tournament {
 public:
  explicit Tournament(int64_t players) {
    for (; leaves_ < players; leaves_ *= 2) ++depth_;
    nodes_.resize(static_cast<size_t>(2 * leaves_));
  }

  double first_time() const { return nodes_[1].time; }
  int first() const { return nodes_[1].player; }

  /// The winner of the subtree at `depth` below the root that contains `player`: the earliest of a 2⁻ᵈᵉᵖᵗʰ of all
  /// players. `depth` is at most log₂ of the number of players, rounded up.
  int first_near(int player, int depth) const {
    return nodes_[static_cast<size_t>((leaves_ + player) >> (depth_ - depth))].player;
  }

  /// Prefetches the lower matches of a player, which set() will read.
  void prefetch(int player) const {
    auto k = static_cast<size_t>(leaves_ + player);
    for (int level = 0; level < 6 && k > 1; ++level, k /= 2) __builtin_prefetch(&nodes_[k]);
  }

  void set(int player, double time) {
    size_t k = static_cast<size_t>(leaves_ + player);
    nodes_[k] = {time, player};
    for (k /= 2; k > 0; k /= 2) {
      const Node& winner = nodes_[2 * k + 1].time < nodes_[2 * k].time ? nodes_[2 * k + 1] : nodes_[2 * k];
      if (winner.player == nodes_[k].player && winner.player != player) return;
      nodes_[k] = winner;
    }
  }

  /// Makes all times earlier by the same amount.
  void shift(double seconds) {
    for (Node& node : nodes_) node.time -= seconds;
  }

  int64_t bytes() const { return static_cast<int64_t>(nodes_.size() * sizeof(Node)); }

 private:
  struct Node {
    double time = kNever;  // [s]
    int32_t player = -1;
  };
  int64_t leaves_ = 1;
  int depth_ = 0;
  std::vector<Node> nodes_;  // [2 · leaves_], the root at 1
};

}  // namespace ballpit
