// SPDX-License-Identifier: MIT
// What two drivers may draw differently is the same, and a fault is not.
#include "export/picture_compare.h"

#include <algorithm>

#include <catch2/catch.hpp>

using namespace ballpit;

namespace {

Image grey(int width, int height) {
  Image image{width, height, std::vector<uint8_t>(static_cast<size_t>(width * height) * 4, 200)};
  for (size_t k = 3; k < image.pixels.size(); k += 4) image.pixels[k] = 255;
  return image;
}

uint8_t* at(Image& image, int x, int y) { return image.pixels.data() + (y * image.width + x) * 4; }

void fill(Image& image, int left, int top, int width, int height, uint8_t value) {
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x) std::fill_n(at(image, x, y), 3, value);
  }
}

}  // namespace

TEST_CASE("a picture is the same as itself, and as one that differs by up to 8 of 255 in each colour") {
  Image a = grey(30, 20), b = a;
  CHECK(comparison_of(a, a).largest == 0);
  fill(b, 0, 0, 30, 20, 208);
  const Comparison near = comparison_of(a, b);
  CHECK(near.is_same());
  CHECK(near.differing == 0);
  CHECK(near.largest == 8);
  fill(b, 0, 0, 30, 20, 209);
  const Comparison far = comparison_of(a, b);
  CHECK_FALSE(far.is_same());
  CHECK(far.differing == 30 * 20);
  CHECK(far.worst_block == 64);
}

TEST_CASE("a single colour that differs is a difference") {
  for (size_t channel = 0; channel < 3; ++channel) {
    Image a = grey(8, 8), b = a;
    for (size_t k = channel; k < b.pixels.size(); k += 4) b.pixels[k] = 100;
    CHECK(comparison_of(a, b).differing == 64);
    CHECK(comparison_of(a, b).largest == 100);
  }
}

TEST_CASE("an edge that lies a pixel further is the same, two pixels further is a difference") {
  Image a = grey(40, 40), one = a, two = a;
  fill(a, 0, 0, 20, 40, 0);
  fill(one, 0, 0, 21, 40, 0);
  fill(two, 0, 0, 22, 40, 0);
  CHECK(comparison_of(a, one).differing == 0);
  CHECK(comparison_of(a, one).largest == 200);
  CHECK(comparison_of(a, two).differing == 2 * 40);  // in each picture, the pixels two away from the other's edge
  CHECK_FALSE(comparison_of(a, two).is_same());
}

TEST_CASE("up to 8 pixels may differ in each block of 8 x 8, and the worst block is named") {
  Image a = grey(32, 24), b = a;
  for (int block = 0; block < 12; ++block) fill(b, block % 4 * 8 + 2, block / 4 * 8 + 2, 4, 2, 0);
  CHECK(comparison_of(a, b).is_same());
  CHECK(comparison_of(a, b).differing == 12 * 8);
  fill(b, 18, 12, 1, 1, 0);
  const Comparison found = comparison_of(a, b);
  CHECK_FALSE(found.is_same());
  CHECK(found.worst_block == 9);
  CHECK(found.left == 16);
  CHECK(found.top == 8);
  fill(b, 26, 20, 1, 1, 0);
  CHECK(comparison_of(a, b).left == 16);        // the first of two that are equal
  CHECK(comparison_of(b, a).worst_block == 9);  // what is missing counts as what is too much
}

TEST_CASE("blocks that the border cuts, and pictures smaller than a block, are compared") {
  Image a = grey(13, 11), b = a;
  fill(b, 10, 8, 3, 3, 0);
  CHECK(comparison_of(a, b).worst_block == 9);
  CHECK(comparison_of(a, b).left == 8);
  Image tiny = grey(1, 1), black = tiny;
  fill(black, 0, 0, 1, 1, 0);
  CHECK(comparison_of(tiny, black).differing == 1);
  CHECK(comparison_of(tiny, black).is_same());
}

TEST_CASE("both pictures stand side by side, and the second one again, pale, with marks on what differs") {
  Image a = grey(10, 6), b = a;
  fill(b, 4, 2, 2, 2, 0);
  Image row = comparison_picture(a, b);
  REQUIRE(row.width == 3 * 10 + 2 * 8);
  REQUIRE(row.height == 6);
  CHECK(row.pixel(4, 2)[0] == 200);
  CHECK(row.pixel(14, 2)[0] == 128);  // the gap
  CHECK(row.pixel(18 + 4, 2)[0] == 0);
  CHECK(row.pixel(36 + 9, 5)[1] == 192 + 200 / 4);
  int marks = 0;
  for (int y = 0; y < 6; ++y) {
    for (int x = 36; x < 46; ++x)
      marks += std::equal(row.pixel(x, y), row.pixel(x, y) + 3, std::vector{0xD5, 0x5E, 0}.begin());
  }
  CHECK(marks == 4 * 4);  // 2 x 2 with their neighbours
}

TEST_CASE("pictures of other sizes stand side by side without marks") {
  Image row = comparison_picture(grey(5, 9), grey(7, 4));
  CHECK(row.width == 5 + 8 + 7);
  CHECK(row.height == 9);
  CHECK(row.pixel(4, 8)[0] == 200);
  CHECK(row.pixel(14, 3)[0] == 200);
  CHECK(row.pixel(14, 4)[0] == 128);
}
