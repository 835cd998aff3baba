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
// about twice the largest number of contacts of a body. A device colours, and solves, in one launch of several phases
// (exec/phases.h), so the host need not know how many colours there are. Sources: Luby, "A Simple Parallel Algorithm
// for the Maximal Independent Set Problem" (1986), doi 10.1137/0215074; Fratarcangeli, Tibaldo, Pellacini, "Vivace"
// (2016), doi 10.1145/2980179.2982437.
#pragma once

#include <algorithm>

#include "bodies/contacts.h"
#include "exec/phases.h"
#include "exec/reduce.h"

namespace ballpit {

/// Kernel: body i names its uncoloured contact of highest priority; −1 if it has none.
template <class V>
struct NameContact {
  ContactsView<V> contacts;
  Span<const int> colour;  ///< from 1 on; 0: none yet
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
      if (colour[c] > 0) return;
      if (best < 0 || priority(uint32_t(c)) > priority(uint32_t(best))) best = c;
    });
    named[i] = best;
  }
};

/// Whether contact c gets a colour in this round, since both of its bodies name it.
struct IsNamed {
  Span<const Pair> pairs;
  Span<const int> named, colour;
  HOST_DEVICE bool operator()(int c) const {
    return colour[c] == 0 && named[pairs[c].i] == c && named[pairs[c].j] == c;
  }
};

/// Kernel: contact c takes the colour of the round if it is named.
struct TakeColour {
  IsNamed is_named;
  int next;
  Span<int> colour;
  HOST_DEVICE void operator()(int c) const {
    if (is_named(c)) colour[c] = next;
  }
};

/// Predicate: contact c has no colour yet.
struct HasNoColour {
  Span<const int> colour;
  HOST_DEVICE bool operator()(int c) const { return colour[c] == 0; }
};

/// Key: the place of the colour of contact c among all colours.
struct ColourOf {
  Span<const int> colour;
  HOST_DEVICE int operator()(int c) const { return colour[c] - 1; }
};

/// Contacts, colour after colour.
struct ColoursView {
  Span<const int> order;
  Span<const int> first;  ///< where each colour begins in `order`
  const int* colours;     ///< how many there are …
  const int* contacts;    ///< … and how many contacts

  HOST_DEVICE int begin(int k) const { return first[k]; }
  HOST_DEVICE int end(int k) const { return k + 1 < *colours ? first[k + 1] : *contacts; }
};

/// Phases: rounds until each contact has a colour. Within a colour, contacts are in the order in which threads come.
template <class V>
struct ColourInRounds {
  NameContact<V> name;
  IsNamed is_named;
  const int* contacts;  ///< how many there are
  Span<int> colour, order, first;
  int* coloured;  ///< how many are; 0 at first
  int* colours;   ///< how many there are in the end; 0 at first
  int round = 0;
  bool names = false;

  HOST_DEVICE bool next() {
    names = !names;
    if (!names) return true;
    ++round;
    return *coloured < *contacts;
  }
  HOST_DEVICE int size() const { return names ? static_cast<int>(name.named.size()) : *contacts; }
  HOST_DEVICE void operator()(int k) const {
    if (names) {
      name(k);
      if (k > 0) return;
      first[round - 1] = *coloured;
      *colours = round;
    } else if (is_named(k)) {
      colour[k] = round;
      order[atomic_add(coloured, 1)] = k;
    }
  }
};

/// Phases: in each iteration all bodies, then all contacts, colour after colour. The second argument of both functions tells
/// whether this is the first iteration.
template <class OnBody, class OnContact>
struct SolveByColour {
  ColoursView colours;
  int bodies, iterations;
  OnBody on_body;
  OnContact on_contact;
  int iteration = 0, colour = -2, begin = 0;

  HOST_DEVICE bool next() {
    if (++colour >= *colours.colours) {
      colour = -1;
      ++iteration;
    }
    if (colour >= 0) begin = colours.begin(colour);
    return iteration < iterations;
  }
  HOST_DEVICE int size() const { return colour < 0 ? bodies : colours.end(colour) - begin; }
  HOST_DEVICE void operator()(int k) const {
    if (colour < 0) {
      on_body(k, iteration == 0);
    } else {
      on_contact(colours.order[begin + k], iteration == 0);
    }
  }
};

template <class V, class Exec>
class ContactColours {
 public:
  void build(Exec& exec, const ContactsView<V>& contacts, int64_t bodies) {
    const int64_t m = contacts.pairs.size();
    colour_.resize(m);
    order_.resize(m);
    named_.resize(bodies);
    counters_.resize(2);
    exec.clear(colour_.span());
    exec.clear(counters_.span());
    contacts_ = contacts.count().count;
    const NameContact<V> name{contacts, colour_.span(), named_.span()};
    const IsNamed is_named{contacts.pairs, named_.span(), colour_.span()};
    if constexpr (Exec::kDefers) {
      first_.resize(m);
      exec.run_phases("colour contacts", std::max(m, bodies),
                      ColourInRounds<V>{name, is_named, contacts_, colour_.span(), order_.span(), first_.span(),
                                        &counters_.span()[0], &counters_.span()[1]});
    } else {
      int& colours = counters_.span()[1];
      while (any(exec, "find colourless", m, HasNoColour{colour_.span()})) {
        exec.parallel_for("name contacts", bodies, name);
        exec.parallel_for("take colours", m, TakeColour{is_named, ++colours, colour_.span()});
      }
      first_.resize(colours + 1);
      exec.bin("sort by colour", ColourOf{colour_.span()}, first_.span(), order_.span());
    }
  }

  ColoursView view() const { return {order_.span(), first_.span(), counters_.span().data() + 1, contacts_}; }

  /// After build(): calls on_body(i, is_first) for each of `bodies` and on_contact(c, is_first) for each contact, in each
  /// iteration (SolveByColour).
  template <class OnBody, class OnContact>
  void solve(Exec& exec, const char* name, int64_t bodies, int iterations, const OnBody& on_body,
             const OnContact& on_contact) const {
    exec.run_phases(
        name, std::max(bodies, named_.size()),
        SolveByColour<OnBody, OnContact>{view(), static_cast<int>(bodies), iterations, on_body, on_contact});
  }

  int64_t bytes() const {
    return colour_.bytes() + order_.bytes() + named_.bytes() + first_.bytes() + counters_.bytes();
  }

 private:
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

  Buffer<int> colour_, order_, named_, first_;
  Buffer<int> counters_;  // contacts that have a colour, on a device; colours
  const int* contacts_ = nullptr;
};

}  // namespace ballpit
