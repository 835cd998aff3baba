// SPDX-License-Identifier: MIT
// Numbers as text, for people and for files.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace ballpit {

/// For people: three significant digits, 12.3 or 1.20e-03, but all digits of the whole part: 1234.
std::string three_digits(double value);

/// For people, in the language set: three significant digits with a prefix of the unit, 9.8e-6 of "s" → "9.80 µs".
/// Without a unit, and beyond the prefixes, with a power of ten: "1.20 × 10⁻⁵". `is_exact`: without zeros at the end,
/// as a number that somebody chose, "1 m".
std::string with_unit(double value, std::string_view unit = "", bool is_exact = false);

/// For people: "10⁻³", "1", "10".
std::string ten_to_the(int power);

/// For people: 12345 → "12 345", with thin spaces.
std::string grouped(int64_t number);

/// For files: the shortest text that reads back as the same double, "0.1", "1e-06", "nan".
std::string number_text(double value);

/// Appends such numbers.
void append_number(std::string& text, double value);
void append_numbers(std::string& text, std::initializer_list<double> values, char separator = ' ');

}  // namespace ballpit
