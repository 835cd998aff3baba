// SPDX-License-Identifier: MIT
// The key of a measurement: words and numbers, in full.
#pragma once

#include <string>
#include <vector>

#include "lab/charts/table.h"

namespace ballpit {

inline std::string key_of(const std::vector<Cell>& parts) {
  std::string line = csv_line(parts);
  line.pop_back();  // its end
  return line;
}

}  // namespace ballpit
