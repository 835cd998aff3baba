// SPDX-License-Identifier: MIT
// Two searches on the same spheres, in turn: ours, the other, ours, the other, … so that whatever slows the machine for
// a while slows both. Every answer is checked, outside the time taken.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "families.h"
#include "peer.h"
#include "reference.h"

namespace ballpit {

/// A family's spheres, at rest and drifting, with what there is to be found.
struct Case {
  std::string family;
  Spheres start;
  std::vector<Pair> start_pairs;  ///< exact, sorted
  std::vector<Spheres> drift;     ///< after 1, 2, … steps, one more than are timed; empty without updates
  PairSet last_set;               ///< exact, after the last step
};

/// With `steps` updates to be timed, or none.
Case make_case(const std::string& family, int64_t count, uint64_t seed, int64_t steps);

enum class Clock {
  wall,
  cpu,  ///< the process's time on all cores: for one thread on a machine that others use as well
};

struct Protocol {
  int cold = 9;    ///< searches from bare arrays
  int drifts = 3;  ///< runs over all steps of the drift
  Clock clock = Clock::wall;
};

/// Milliseconds: per search when cold; per step, averaged over a drift, for updates, so that a structure that is
/// rebuilt now and then pays for it.
struct Timing {
  double median = 0;
  double spread = 0;  ///< between the quartiles
};

Timing timing_of(std::vector<double> milliseconds);

struct Row {
  std::string family;
  int64_t count = 0;
  int threads = 0;
  std::string peer;
  std::string mode;  ///< "cold" or "update"
  Timing ours;
  Timing theirs;
  int64_t pairs = 0;   ///< at the start
  bool equal = false;  ///< all sets, ours and theirs

  double ratio() const { return theirs.median / ours.median; }
};

Row compare_cold(const Case& spheres, const PeerInfo& peer, const PeerOptions& options, const Protocol& protocol);
Row compare_updates(const Case& spheres, const PeerInfo& peer, const PeerOptions& options, const Protocol& protocol);

}  // namespace ballpit
