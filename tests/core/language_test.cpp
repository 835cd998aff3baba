// SPDX-License-Identifier: MIT
#include "core/language.h"

#include <catch2/catch.hpp>

#include "core/numbers.h"
#include "tests/support/in_german.h"

using namespace ballpit;

TEST_CASE("a text is in the language set, and stays English where the table lacks it") {
  CHECK(translated("Scene") == "Scene");
  const InGerman in_german;
  CHECK(translated("Scene") == "Szene");
  CHECK(translated("no such text") == "no such text");
}

TEST_CASE("numbers for people have three digits, a prefix, and the decimal sign of the language") {
  CHECK(with_unit(9.8e-6, "s") == "9.80 µs");
  CHECK(with_unit(16.94e3, "J") == "16.9 kJ");
  CHECK(with_unit(-0.25, "m") == "-250 mm");
  CHECK(with_unit(1, "m", true) == "1 m");
  CHECK(with_unit(1 / 240.0, "s", true) == "4.17 ms");
  CHECK(with_unit(0, "J") == "0 J");
  CHECK(with_unit(1000, "J") == "1.00 kJ");
  CHECK(with_unit(1e-5) == "1.00 × 10⁻⁵");
  CHECK(with_unit(1.2e21, "J") == "1.20 × 10²¹ J");
  CHECK(with_unit(INFINITY, "J") == "inf J");
  CHECK(local_number("2.5") == "2.5");
  const InGerman in_german;
  CHECK(with_unit(9.8e-6, "s") == "9,80 µs");
  CHECK(local_number("2.5 of 1.25. Then .5") == "2,5 of 1,25. Then ,5");
}
