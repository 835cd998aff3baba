// SPDX-License-Identifier: MIT
// The rows of a comparison as a table, as CSV and as JSON, and a summary for each library.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "compare.h"

namespace ballpit {

/// Over all families, for one library and one mode. Ratios are their time over ours: above 1, ours is faster.
struct Summary {
  std::string peer;
  std::string mode;
  double geometric_mean = 0;
  double worst = 0;
  std::string worst_family;
};

std::vector<Summary> summarize(const std::vector<Row>& rows);

std::string table_head();
std::string table_line(const Row& row);
std::string table_foot(const std::vector<Summary>& summaries);

std::string csv_of(const std::vector<Row>& rows);
nlohmann::ordered_json json_of(const std::vector<Row>& rows);

/// CPU, compiler and build type, on which the times depend.
nlohmann::ordered_json machine();

}  // namespace ballpit
