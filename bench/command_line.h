// SPDX-License-Identifier: MIT
// Command lines of the benchmarks: checks of values, and the exit status.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/error.h"

namespace ballpit {

inline void require(bool allowed, const char* option, const std::string& found, const std::string& what_is_allowed) {
  if (!allowed) throw UserError(option, found, what_is_allowed);
}

inline void require_names(const char* option, const std::vector<std::string>& found,
                          const std::vector<std::string>& allowed) {
  for (const std::string& name : found) {
    require(std::find(allowed.begin(), allowed.end(), name) != allowed.end(), option, name, join(allowed));
  }
}

inline void require_range(const char* option, int64_t found, int64_t low, int64_t high) {
  require(found >= low && found <= high, option, std::to_string(found), fmt::format("{} to {}", low, high));
}

/// Parses the command line and runs. Returns the exit status: 0 done, 1 the run failed, 2 wrong options.
inline int run_command(CLI::App& app, int argc, char** argv, const std::function<void()>& run) {
  const auto fail = [&](int status, const char* message) {
    std::cerr << app.get_name() << ": " << message << "\n";
    return status;
  };
  try {
    app.parse(argc, argv);
    run();
    return 0;
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : fail(2, error.what());
  } catch (const UserError& error) {
    return fail(2, error.what());
  } catch (const std::exception& error) {
    return fail(1, error.what());
  }
}

}  // namespace ballpit
