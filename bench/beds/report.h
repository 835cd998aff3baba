// SPDX-License-Identifier: MIT
// The rows of a comparison of beds as a table to read, as CSV and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "compare.h"

namespace ballpit {

std::string table_head();
std::string table_line(const BedRow& row);

/// Fields of a program that was left out are empty.
std::string csv_of(const std::vector<BedRow>& rows, const Stretch& stretch);
nlohmann::ordered_json json_of(const std::vector<BedRow>& rows);

}  // namespace ballpit
