// SPDX-License-Identifier: MIT
// What a search for pairs found and took, as JSON and as text; and the pairs themselves, as CSV.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "measure/exact_pairs.h"
#include "measure/work_profile.h"
#include "world/pair_search.h"

namespace ballpit {

struct PairsOutcome {
  std::string file;
  int64_t count = 0;            ///< spheres
  std::optional<Vec3d> period;  ///< [m] 0 along axes that have none; empty without any
  std::string backend;
  int threads = 0;              ///< of the CPU; 0 where it does not search
  std::vector<double> seconds;  ///< [s] of each search, from bare arrays to the list
  SearchReport report;
  WorkProfile work;
  std::optional<Deviation> deviation;  ///< from the exact reference, where that was asked for
};

nlohmann::ordered_json summarize(const PairsOutcome& outcome);

/// The same for people: a few aligned lines.
std::string describe_pairs(const nlohmann::ordered_json& summary);

/// "i,j", then a pair a line.
std::string pairs_csv(const std::vector<Pair>& pairs);

}  // namespace ballpit
