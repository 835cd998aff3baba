// SPDX-License-Identifier: MIT
// Which colour a value takes, and what the legend says.
#include "render/color_scale.h"

#include <numeric>

#include <catch2/catch.hpp>

using namespace ballpit;

namespace {

int step(Mark mark) { return static_cast<int>(mark) - 2; }

std::vector<std::string> texts(const Colored& colored) {
  std::vector<std::string> result;
  for (const LegendBox& box : colored.boxes) result.push_back(box.text);
  return result;
}

/// 0, 1, …, `last`.
std::vector<int> up_to(int last) {
  std::vector<int> values(static_cast<size_t>(last) + 1);
  std::iota(values.begin(), values.end(), 0);
  return values;
}

}  // namespace

TEST_CASE("a scale ends where 98 % of the values do, and larger ones take its last colour") {
  std::vector<float> values;
  for (int k = 1; k <= 100; ++k) values.push_back(static_cast<float>(k));
  values[99] = 1e6f;
  const Colored colored = on_scale(values, " m/s", true);
  CHECK(colored.low == "0 m/s");
  CHECK(colored.high == "≥ 98 m/s");
  CHECK(step(colored.marks[48]) == 8);  // 49 of 98
  CHECK(step(colored.marks[97]) == 15);
  CHECK(step(colored.marks[99]) == 15);
  CHECK(colored.boxes.empty());
}

TEST_CASE("of fewer than fifty values all are on the scale") {
  const Colored colored = on_scale({1, 2, 3, 1000}, " m", false);
  CHECK(colored.low == "1 m");
  CHECK(colored.high == "1e+03 m");
  CHECK(step(colored.marks[2]) == 0);
}

TEST_CASE("a scale reaches to the largest value if nearly all values are equal") {
  std::vector<float> values(1000, 2);
  values[7] = 5;
  const Colored colored = on_scale(values, "", false);
  CHECK(colored.high == "5");
  CHECK(step(colored.marks[7]) == 15);
  CHECK(step(colored.marks[8]) == 0);
  CHECK(on_scale({3, 3}, "", false).high == "3");
  CHECK_FALSE(on_scale({}, "", false).has_scale());
}

TEST_CASE("up to ten whole numbers have a colour each, from the first to the last of the scale") {
  const Colored colored = on_whole_numbers({0, 1, 2, 3, 3}, 0);
  CHECK(texts(colored) == std::vector<std::string>{"0", "1", "2", "3"});
  CHECK(step(colored.marks[0]) == 0);
  CHECK(step(colored.marks[1]) == 5);
  CHECK(step(colored.marks[4]) == 15);
  for (size_t k = 0; k < 4; ++k) CHECK(colored.boxes[k].mark == colored.marks[k]);
  CHECK(texts(on_whole_numbers(up_to(9), 0)).size() == 10);
  CHECK(texts(on_whole_numbers({0, 0}, 0)) == std::vector<std::string>{"0"});
  CHECK(texts(on_whole_numbers({1, 2, 1}, 1)) == std::vector<std::string>{"1", "2"});
  CHECK_FALSE(on_whole_numbers({}, 0).has_scale());
}

TEST_CASE("more whole numbers have a colour for each of at most five equal ranges") {
  const Colored colored = on_whole_numbers(up_to(10), 0);
  CHECK(texts(colored) == std::vector<std::string>{"0–2", "3–5", "6–8", "9–11"});
  CHECK(step(colored.marks[2]) == 0);
  CHECK(step(colored.marks[3]) == 5);
  CHECK(step(colored.marks[10]) == 15);
  CHECK(texts(on_whole_numbers(up_to(49), 1)) == std::vector<std::string>{"1–10", "11–20", "21–30", "31–40", "41–50"});
  for (const int last : {11, 99, 1000, 123456}) CHECK(texts(on_whole_numbers({0, last}, 0)).size() <= 5);
  CHECK(on_whole_numbers({0, 2'000'000'000}, 0).boxes.size() == 5);
}

TEST_CASE("the last box of the legend is open where few values are larger") {
  std::vector<int> values(1000, 1);
  values[3] = 40;
  CHECK(texts(on_whole_numbers(values, 0)) == std::vector<std::string>{"0", "≥ 1"});
  CHECK(on_whole_numbers(values, 0).marks[3] == on_whole_numbers(values, 0).marks[4]);
  std::vector<int> many = up_to(999);
  many[0] = 100000;
  CHECK(texts(on_whole_numbers(many, 0)).back() == "≥ 800");
}
