// SPDX-License-Identifier: MIT
#include "tests/cli/messages_table.h"

namespace ballpit {

std::vector<Row> rows_of_masses() {
  return {
      {"scene/mass_ratio.cpp: have two masses",
       "--mass-ratio: found 100, allowed only in a scene whose [[spheres]] have two masses, not 1",
       {"simulate", "cradle", "--time", "0", "--mass-ratio", "100"}},
      {"scene/mass_ratio.cpp: a mass of",
       "--mass-ratio: found 8e+05, a mass of 8e+30 kg, allowed 1e-30 to 1e+30 kg",
       {"simulate", "a.toml", "--time", "0", "--mass-ratio", "8e5"},
       kBox + kSphere + "mass = 1e25\n[[spheres]]\nposition = [2, 2, 2]\nradius = 1\nmass = 2e25\n"},
  };
}

}  // namespace ballpit
