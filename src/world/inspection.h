// SPDX-License-Identifier: MIT
// What the simulation shows of itself: copies on the host, so that looking never changes the world.
#pragma once

#include "bodies/body_snapshot.h"
#include "bodies/pair.h"
#include "broad_phase/inspection.h"
#include "world/ghost_inspection.h"

namespace ballpit {

/// What an inspection contains besides the number of bodies.
struct Wanted {
  bool state = true;  ///< positions, velocities, radii, contacts and cell lists
  bool candidates = false;
  bool missed = false;     ///< brute force is the oracle: O(n²) tests
  bool endpoints = false;  ///< and the axis
  bool work = false;
  bool occluders = false;  ///< of the bodies
  bool ghost = false;      ///< by the demonstration that keeps one; worlds have none

  bool more_than_state() const { return candidates || missed || endpoints || work; }

  Wanted operator|(const Wanted& other) const {
    return {state || other.state, candidates || other.candidates, missed || other.missed, endpoints || other.endpoints,
            work || other.work,   occluders || other.occluders,   ghost || other.ghost};
  }
  bool operator==(const Wanted&) const = default;
};

struct Inspection {
  BodySnapshot bodies;
  std::vector<Pair> contacts;         ///< overlapping pairs that the method found, sorted by i, then j
  std::vector<GridInspection> grids;  ///< of the broad phase: one for each size class, or none

  // If wanted. Found by a search of the present positions without a candidate list.
  std::vector<Pair> candidates;     ///< pairs that the broad phase gives to the narrow phase, sorted
  std::vector<Pair> missed;         ///< overlapping pairs that the method did not find, sorted
  int axis = -1;                    ///< along which sort-and-sweep sorts: 0, 1, 2; −1 for other methods
  std::vector<Endpoint> endpoints;  ///< its sorted list, by `at`
  std::vector<int> work;            ///< candidates of each thread
  std::vector<int32_t> worker;      ///< the body of each thread; −1 for an idle thread
  std::optional<GhostInspection> ghost;
};

}  // namespace ballpit
