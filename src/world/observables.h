// SPDX-License-Identifier: MIT
// What can be read off a run: one table of observables, which feeds command line, lists and documentation. Each is computed
// when it is asked for. Cost: O(spheres), but for missed contacts, which take a search.
//
// Figures that need the history of collisions take it from Report::tally, which a world keeps where its settings ask for it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "world/world.h"

namespace ballpit {

/// What observables are computed from.
struct Observation {
  Domain domain;
  Bodies bodies;  ///< the present state
  Report report;  ///< of the same state
  std::function<int64_t()>
      missed_contacts{};  ///< searches for them: pairs that touch, but that the method did not find
};

/// One number; three of a vector; none where there is no value, as of a rate over no time.
using ObservedValue = std::vector<double>;

struct Observable {
  std::string_view name;         ///< as on the command line
  std::string_view label;        ///< as the audience reads it
  std::string_view unit;         ///< "1" where it has none
  std::string_view planar_unit;  ///< the same in a planar scene
  std::string_view estimator;    ///< one sentence: how the value is made
  bool needs_tally;
  ObservedValue (*compute)(const Observation&);  ///< not finite where there is no value; measure() takes care of it
};

std::span<const Observable> observables();

/// The observable's value. Where it would not be finite, there is none.
ObservedValue measure(const Observable& observable, const Observation& observation);

std::string_view unit_of(const Observable& observable, const Domain& domain);

}  // namespace ballpit
