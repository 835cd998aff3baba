// SPDX-License-Identifier: MIT
// Ctrl-C ends long runs between two frames or steps, so that what was written is whole.
#pragma once

namespace ballpit {

/// From now on SIGINT and SIGTERM are noted instead of ending the program; a second one ends it at once.
void catch_interrupts();

bool was_interrupted();

}  // namespace ballpit
