// SPDX-License-Identifier: MIT
// Finds and runs other programs.
#pragma once

#include <string>
#include <vector>

namespace ballpit {

/// The path of a program on the PATH; empty if there is none. A `name` with a slash is a path already.
std::string find_program(const std::string& name);

struct ProgramCall {
  std::string path;
  std::vector<std::string> arguments = {};
  std::string input = "";       ///< standard input
  std::string folder = "";      ///< working directory; empty: ours
  bool gets_interrupts = true;  ///< Ctrl-C ends the program too
};

struct ProgramResult {
  int status;  ///< exit status, or 128 + the number of the signal that ended it
  std::string output, errors;
};

/// Runs a program and waits for its end. Throws RunError if it cannot be started.
ProgramResult run_program(const ProgramCall& call);

}  // namespace ballpit
