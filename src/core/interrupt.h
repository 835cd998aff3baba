// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and a closed terminal end long runs between two frames, steps or events, so that what was written is whole.
#pragma once

#include <exception>

namespace ballpit {

/// A long step ended early because was_interrupted(). Not a RunError: the run did not fail, and must not be recorded as failed.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// From now on SIGINT, SIGTERM and SIGHUP are noted instead of ending the program; a second SIGINT or SIGTERM ends it at once.
/// A second SIGHUP does not: a shell and the system each send one when a terminal is closed. SIGHUP stays ignored where the
/// program was started so (nohup). A system call that waits (for the reader of a pipe) ends with EINTR.
void catch_interrupts();

bool was_interrupted();

/// Throws Interrupted where the program was interrupted.
void stop_if_interrupted();

}  // namespace ballpit
