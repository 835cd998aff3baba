// SPDX-License-Identifier: MIT
// Measured numbers as the audience reads them; for counted ones see grouped() in render/painter.h.
#pragma once

#include <string>

namespace ballpit {

/// At most three digits that move: 12.3, 0.0123, 1230.
std::string three_digits(double value);

}  // namespace ballpit
