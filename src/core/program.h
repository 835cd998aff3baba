// SPDX-License-Identifier: MIT
// Finds and runs other programs.
#pragma once

#include <memory>
#include <string>
#include <string_view>
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
ProgramResult call_program(const ProgramCall& call);

/// A program that reads its input from a pipe while it runs. Killed by the destructor if nobody has waited for its end.
class PipedProgram {
 public:
  /// `call.input` is not used. Throws RunError if the program cannot be started.
  explicit PipedProgram(const ProgramCall& call);
  ~PipedProgram();
  PipedProgram(const PipedProgram&) = delete;
  PipedProgram& operator=(const PipedProgram&) = delete;

  /// Waits until the program has read almost all of it. Returns false if the program reads no more. Throws Interrupted.
  bool write(std::string_view bytes);

  /// Ends the input and waits for the program's end. Throws Interrupted.
  ProgramResult finish();

 private:
  struct Output;
  std::unique_ptr<Output> output_;
  int input_ = -1;  ///< our end of the pipe
  int process_ = -1;
};

}  // namespace ballpit
