// SPDX-License-Identifier: MIT
// The messages of the program: a row for each place in src/ that makes one, with a command line that reaches it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/run_program.h"

namespace ballpit {

/// Where the program runs, and what runs it; what it says, and which site says so: "FILE: a part of its code".
struct Row {
  std::string site, said;
  Arguments arguments;
  std::string text = {};  ///< of a.toml and a.csv
  std::vector<std::pair<const char*, std::string>> variables = {};
  Circumstances circumstances = {};
  bool is_interrupted = false;
};

/// A site that no command line reaches, with the reason.
struct Unreached {
  std::string site, reason;
};

const Arguments kRender{"render", "two-spheres", "--size", "64x36", "--frames", "1", "--out", "film"};

/// A command that is interrupted while it runs.
Row interrupted(const std::string& site, const std::string& said, const Arguments& arguments);

/// kRender with more options.
Arguments render(const Arguments& more);

const std::string kBox = "[domain]\nmin = [0, 0, 0]\nmax = [10, 10, 10]\n";
const std::string kSphere = "[[spheres]]\nposition = [5, 5, 5]\nradius = 1\n";

std::vector<Row> rows_of_lectures();
std::vector<Row> rows_of_masses();
std::vector<Row> rows_of_choices();
std::vector<Row> rows_of_acts();
std::vector<Row> rows_of_views();
std::vector<Row> rows_of_pictures();
std::vector<Unreached> unreached_of_choices();
std::vector<Unreached> unreached_of_pictures();
std::vector<Row> all_rows();
const std::vector<Unreached>& unreached();

}  // namespace ballpit
