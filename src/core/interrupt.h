// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and a closed terminal end long runs between two frames, steps or events, so that all output is complete.
#pragma once

#include <exception>

namespace ballpit {

/// Thrown when a long step ends early because of was_interrupted(). Not a RunError: the run has not failed.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// From now on SIGINT, SIGTERM and SIGHUP set was_interrupted() instead of ending the program. A second SIGINT or SIGTERM ends
/// it at once. A second SIGHUP does not: a shell and the system each send one when a terminal is closed. SIGHUP stays ignored
/// if the program was started that way (nohup). A waiting system call (for the reader of a pipe) ends with EINTR.
void catch_interrupts();

bool was_interrupted();

/// Throws Interrupted if the program was interrupted.
void stop_if_interrupted();

}  // namespace ballpit
