// SPDX-License-Identifier: MIT
// Two searches on the same spheres, in turns: ours, the other, ours, the other, … so that other load on the machine
// slows both. Every result is checked against the exact reference (measure/exact_pairs.h), outside the measured time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "families.h"
#include "peer.h"
#include "world/pair_search.h"

namespace ballpit {

/// Views of spheres, for our own search.
inline SphereArrays arrays_of(const Spheres& spheres) {
  return {{spheres.position.data(), spheres.count()},
          {spheres.radius.data(), static_cast<int64_t>(spheres.radius.size())}};
}

/// A set of pairs in two numbers, which do not depend on order and direction.
struct PairSet {
  int64_t count = 0;
  uint64_t hash = 0;
  friend bool operator==(const PairSet&, const PairSet&) = default;
};

/// The spheres of a family, at rest and drifting, with the pairs that searches must find.
struct Case {
  std::string family;
  Spheres start;
  std::vector<Pair> start_pairs;  ///< exact, sorted
  std::vector<Spheres> drift;     ///< after 1, 2, … steps, one more than are timed; empty without updates
  PairSet last_set;               ///< exact, after the last step
};

/// `steps`: the number of updates to be timed, 0 for none.
Case make_case(const std::string& family, int64_t count, uint64_t seed, int64_t steps);

enum class Clock {
  wall,
  cpu,  ///< time of the process on all cores: for one thread on a busy machine
};

struct Protocol {
  int cold = 9;    ///< searches from bare arrays
  int drifts = 3;  ///< runs over all steps of the drift
  Clock clock = Clock::wall;
};

/// [ms] of a cold search; for updates, of a step, averaged over a drift, which includes the occasional rebuilding of a
/// structure.
struct PeerTiming {
  double median = 0;
  double spread = 0;  ///< between the quartiles
};

struct Row {
  std::string family;
  int64_t count = 0;
  int threads = 0;
  std::string peer;
  std::string mode;  ///< "cold" or "update"
  PeerTiming ours;
  PeerTiming theirs;
  int64_t pairs = 0;   ///< at the start
  bool equal = false;  ///< all sets, ours and theirs

  double ratio() const { return theirs.median / ours.median; }
};

Row compare_cold(const Case& spheres, const PeerInfo& peer, const PeerOptions& options, const Protocol& protocol);
Row compare_updates(const Case& spheres, const PeerInfo& peer, const PeerOptions& options, const Protocol& protocol);

}  // namespace ballpit
