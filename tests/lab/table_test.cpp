// SPDX-License-Identifier: MIT
#include "lab/charts/table.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

using namespace ballpit;

TEST_CASE("cells of a line read back as they were written") {
  const std::vector<Cell> cells{0.1, "plain", "a, b", "say \"so\"", 1e-300, -3.0, "", std::nan("")};
  const std::string line = csv_line(cells);
  REQUIRE(line.back() == '\n');
  const std::vector<std::string> read = split_csv_line(std::string_view(line).substr(0, line.size() - 1));
  CHECK(read == std::vector<std::string>{"0.1", "plain", "a, b", "say \"so\"", "1e-300", "-3", "", ""});
}

TEST_CASE("a table is comments, a header with units, and its rows") {
  const Table table{"times", {"method", "time [ms]"}, {{"linked-cell", 1.5}}};
  CHECK(csv_of(table, {"machine: A, 2 cores", "seed: 1"}) ==
        "# machine: A, 2 cores\n# seed: 1\nmethod,time [ms]\nlinked-cell,1.5\n");
}
