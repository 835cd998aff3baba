// SPDX-License-Identifier: MIT
// Gives each contact a colour. No two contacts of one colour share a body, so all contacts of a colour may be solved in
// parallel, colour after colour (Gauss–Seidel), and the result does not depend on the number of threads.
//
//     contacts   (0,1) (1,2) (2,3) (3,4)       round 0: each body names its contact of highest priority;
//     priority     .3    .9    .5    .7                 (1,2) and (3,4) are named by both of their bodies
//     colour        1     0     1     0        round 1: the same among the rest: (0,1) and (2,3)
//
// The colour of a contact is the round in which both of its bodies name it. Priorities are hashes of the contacts'
// indices, so a chain of contacts takes O(log n) rounds, not n. Cost: O(contacts) a round; the number of rounds is
// about twice the largest number of contacts of a body. Sources: Luby, "A Simple Parallel Algorithm for the Maximal
// Independent Set Problem" (1986), doi 10.1137/0215074; Fratarcangeli, Tibaldo, Pellacini, "Vivace" (2016), doi
// 10.1145/2980179.2982437.
#pragma once

#include <vector>

#include "bodies/contacts.h"
#include "exec/reduce.h"

namespace ballpit {

/// Kernel: body i names its uncoloured contact of highest priority; −1 if it has none.
template <class V>
struct NameContact {
  ContactsView<V> contacts;
  Span<const int> colour;
  Span<int> named;

  /// A permutation of 32 bits (Wellons, "lowbias32"): different contacts have different priorities.
  HOST_DEVICE static uint32_t priority(uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7FEB352Du;
    x = (x ^ (x >> 15)) * 0x846CA68Bu;
    return x ^ (x >> 16);
  }

  HOST_DEVICE void operator()(int i) const {
    int best = -1;
    contacts.for_each_of(i, [&](int c, int, int) {
      if (colour[c] >= 0) return;
      if (best < 0 || priority(uint32_t(c)) > priority(uint32_t(best))) best = c;
    });
    named[i] = best;
  }
};

/// Kernel: contact c takes the colour of the round if both of its bodies name it.
struct TakeColour {
  Span<const Pair> pairs;
  Span<const int> named;
  int round;
  Span<int> colour;

  HOST_DEVICE void operator()(int c) const {
    if (colour[c] < 0 && named[pairs[c].i] == c && named[pairs[c].j] == c) colour[c] = round;
  }
};

/// Predicate: contact c has no colour yet.
struct HasNoColour {
  Span<const int> colour;
  HOST_DEVICE bool operator()(int c) const { return colour[c] < 0; }
};

template <class V, class Exec>
class ContactColours {
 public:
  void build(Exec& exec, const ContactsView<V>& contacts, int64_t bodies) {
    const int64_t m = contacts.pairs.size();
    colour_.resize(m);
    order_.resize(m);
    named_.resize(bodies);
    exec.fill("clear colours", colour_.span(), -1);
    int rounds = 0;
    while (any(exec, "find colourless", m, HasNoColour{colour_.span()})) {
      exec.parallel_for("name contacts", bodies, NameContact<V>{contacts, colour_.span(), named_.span()});
      exec.parallel_for("take colours", m, TakeColour{contacts.pairs, named_.span(), rounds++, colour_.span()});
    }
    offsets_.resize(rounds + 1);
    exec.bin("sort by colour", ReadValue<int>{colour_.span()}, offsets_.span(), order_.span());
    first_ = exec.download(offsets_.span());
  }

  /// Calls visit(contacts) for each colour in turn.
  template <class Visit>
  void for_each(Visit&& visit) const {
    const Span<const int> order = order_.span();
    for (size_t k = 0; k + 1 < first_.size(); ++k) {
      visit(Span<const int>(order.data() + first_[k], first_[k + 1] - first_[k]));
    }
  }

  int64_t bytes() const { return colour_.bytes() + order_.bytes() + named_.bytes() + offsets_.bytes(); }

 private:
  typename Exec::template Buffer<int> colour_, order_, named_, offsets_;
  std::vector<int> first_{0};
};

}  // namespace ballpit
