// SPDX-License-Identifier: MIT
// Runs `ballpit pairs` for the tests.
#pragma once

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "methods/choices.h"
#include "tests/support/run_program.h"

namespace ballpit {

/// Overlapping, touching (0 and 1: exactly), alone.
inline const std::string kFour = "x,y,z,radius\n0,0,0,1\n3,0,0,2\n1,1,0,0.5\n9,9,9,1\n";
inline const std::string kPairsOfFour = "i,j\n0,1\n0,2\n1,2\n";

/// The summary of `ballpit pairs --json`.
inline nlohmann::json pairs(Arguments arguments) {
  arguments.insert(arguments.begin(), "pairs");
  arguments.emplace_back("--json");
  const Outcome outcome = run_program(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.err.empty());
  return outcome.json();  // throws if there is anything but the object
}

inline std::vector<std::string> search_methods() {
  std::vector<std::string> names;
  for (const std::string_view name : kNames<BroadPhase>) names.emplace_back(name);
  return names;
}

}  // namespace ballpit
