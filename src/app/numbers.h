// SPDX-License-Identifier: MIT
// Numbers as the audience reads them.
#pragma once

#include <cstdint>
#include <string>

namespace ballpit {

/// 1 234 567, with thin spaces.
std::string with_thin_spaces(int64_t value);

/// At most three digits that move: 12.3, 0.0123, 1230.
std::string three_digits(double value);

}  // namespace ballpit
