// SPDX-License-Identifier: MIT
// Numbers as the audience reads them.
#pragma once

#include <cstdint>
#include <string>

namespace ballpit {

/// At most three digits that move: 12.3, 0.0123, 1230.
std::string three_digits(double value);

/// 12345 → "12 345", with thin spaces.
std::string grouped(int64_t number);

}  // namespace ballpit
