// SPDX-License-Identifier: MIT
// Runs `ballpit simulate` for the tests.
#pragma once

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/run_program.h"

namespace ballpit {

/// Runs `ballpit simulate --json`, and requires that it succeeds.
inline Outcome run_simulate(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "simulate");
  arguments.emplace_back("--json");
  const Outcome outcome = run_program(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return outcome;
}

}  // namespace ballpit
