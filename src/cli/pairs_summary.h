// SPDX-License-Identifier: MIT
// The outcome of a search for pairs, as JSON and as text; and the pairs themselves, as CSV.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "measure/exact_pairs.h"
#include "measure/statistics.h"
#include "world/pair_search.h"

namespace ballpit {

struct PairsOutcome {
  std::string file;
  int64_t count = 0;            ///< spheres
  std::optional<Vec3d> period;  ///< [m] 0 along axes without a period; empty without any
  std::string backend;
  int threads = 0;              ///< of the CPU; 0 if it does not search
  std::vector<double> seconds;  ///< [s] of each search, from bare arrays to the list
  SearchReport report;
  WorkProfile work;
  std::optional<Deviation> deviation;  ///< from the exact reference, if it was computed
};

nlohmann::ordered_json json_of(const PairsOutcome& outcome);

/// Aligned lines.
std::string text_of(const PairsOutcome& outcome);

/// "i,j", then one pair a line.
std::string pairs_csv(const std::vector<Pair>& pairs);

}  // namespace ballpit
