// SPDX-License-Identifier: MIT
// Numbers as text, for people and for files.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>

namespace ballpit {

/// For people: three significant digits, 12.3 or 1.20e-03, but all digits of the whole part: 1234.
std::string three_digits(double value);

/// For people: 12345 → "12 345", with thin spaces.
std::string grouped(int64_t number);

/// For files: the shortest text that reads back as the same double, "0.1", "1e-06", "nan".
std::string number_text(double value);

/// Appends such numbers.
void append_number(std::string& text, double value);
void append_numbers(std::string& text, std::initializer_list<double> values, char separator = ' ');

}  // namespace ballpit
