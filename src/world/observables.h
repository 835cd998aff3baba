// SPDX-License-Identifier: MIT
// The table of observables, for command line, lists and documentation. Cost: O(spheres) each; missed contacts take a search.
// Observables of past collisions use Report::tally, which a world keeps if its settings ask for it.
#pragma once

#include "world/world.h"

namespace ballpit {

/// What observables are computed from.
struct Observation {
  Domain domain;
  Bodies bodies;                               ///< the present state
  Report report;                               ///< of the same state; its time and tally are those of the observation
  std::vector<Vec3d> ways{};                   ///< [m] that each sphere has moved in this time; empty: not followed
  std::function<int64_t()> missed_contacts{};  ///< searches for pairs in contact that the method did not find
};

/// One number, three for a vector, or none if there is no value, as for a rate at time 0.
using ObservedValue = std::vector<double>;

struct Observable {
  std::string_view name;         ///< as on the command line
  std::string_view label;        ///< for people
  std::string_view unit;         ///< "1" if it has none
  std::string_view planar_unit;  ///< the same in a planar scene
  std::string_view estimator;    ///< one sentence: how the value is made
  bool needs_tally;
  ObservedValue (*compute)(const Observation&);  ///< not finite if there is no value
  bool needs_ways = false;
};

std::span<const Observable> observables();

/// The observable's value, or none if it is not finite.
ObservedValue measure(const Observable& observable, const Observation& observation);

std::string_view unit_of(const Observable& observable, const Domain& domain);

}  // namespace ballpit
