// SPDX-License-Identifier: MIT
// Turns the errors that OpenGL reports (KHR_debug) into exceptions.
#pragma once

#include <string>

namespace ballpit {

/// Makes the current context keep messages about errors for check_gl().
void enable_gl_debug();

/// Throws RunError with all errors of the current context since the last check; `doing` names the operation.
void check_gl(const std::string& doing);

}  // namespace ballpit
