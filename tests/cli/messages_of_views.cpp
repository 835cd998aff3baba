// SPDX-License-Identifier: MIT
#include "tests/cli/messages_table.h"

namespace ballpit {

std::vector<Row> rows_of_views() {
  const auto compared = [](const Arguments& more) {
    return with({"render", "two-spheres", "--frames", "1", "--out", "film"}, more);
  };
  return {
      {"show/comparison.cpp: name, allowed", "--compare: found auto, allowed two to 4 different ones of brute-force,",
       compared({"--compare", "brute-force,auto"})},
      {"show/comparison.cpp: text, allowed", "--compare: found brute-force, allowed two to 4 different ones of",
       compared({"--compare", "brute-force"})},
      {"show/comparison.cpp: option.name",
       "--broadphase: found linked-cell with --compare, allowed the broad phases of --compare alone",
       compared({"--compare", "brute-force,linked-cell", "--broadphase", "linked-cell"})},
      {"show/comparison.cpp: --size", "--size: found 64x36 with --compare of 2 methods, allowed at least 240x180",
       render({"--compare", "brute-force,linked-cell"})},
      {"cli/options.cpp: --turn",
       "--turn: found 6 with lecture-grid, which is planar, allowed 0, or a scene of three",
       {"render", "lecture-grid", "--turn", "6", "--frames", "1", "--out", "film"}},
  };
}

}  // namespace ballpit
