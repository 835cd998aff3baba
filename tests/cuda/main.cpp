// SPDX-License-Identifier: MIT
// Runs the CUDA tests, or says why it cannot and returns 77, which ctest counts as skipped.
#define CATCH_CONFIG_RUNNER
#include <iostream>

#include <catch2/catch.hpp>

#include "world/world.h"

int main(int argc, char** argv) {
  Catch::Session session;
  if (const int wrong = session.applyCommandLine(argc, argv)) return wrong;
  const auto& config = session.configData();
  const bool only_lists = config.listTests || config.listTestNamesOnly || config.listTags || config.listReporters;
  const std::string reason = ballpit::cuda_backend().unavailable_reason;
  if (!only_lists && !reason.empty()) {
    std::cout << "skipped: CUDA cannot serve here: " << reason << "\n";
    return 77;
  }
  return session.run();
}
