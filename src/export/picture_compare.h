// SPDX-License-Identifier: MIT
// Compares two pictures of the same content that two drivers may have drawn. Graphics drivers round differently, so a few
// pixels at edges differ although nothing is wrong. A fault differs in many pixels at one place. Means over a picture cannot
// tell these apart: a missing sphere had a better mean than rounding. So
//
//   - a pixel differs if none of the 3 × 3 pixels around its place in the other picture is within 8/255 in each colour;
//   - the pictures differ if, in one of the blocks of 8 × 8 pixels, more than 8 pixels differ.
//
// `ballpit compare` and the tests' golden pictures use it. Cost: up to 18 comparisons a pixel, one where pictures are equal.
#pragma once

#include <cstdint>

#include "render/image.h"

namespace ballpit {

constexpr int kCompareBlock = 8;          ///< [px] edge of a block
constexpr int kMaxDifferingInBlock = 8;   ///< pixels that may differ in a block
constexpr int kMaxChannelDifference = 8;  ///< of 255, between pixels that are alike

struct Comparison {
  int64_t differing = 0;  ///< pixels that differ in the whole picture
  int largest = 0;        ///< difference of a colour at the same place, of 255
  int worst_block = 0;    ///< pixels that differ in the block in which most do
  int left = 0, top = 0;  ///< [px] of that block

  bool is_same() const { return worst_block <= kMaxDifferingInBlock; }
};

/// Two pictures of the same size.
Comparison comparison_of(const Image& a, const Image& b);

/// Both pictures side by side. If they have the same size, a third one follows: b, pale, with all pixels that differ and
/// their neighbours in vermillion.
Image comparison_picture(const Image& a, const Image& b);

/// The largest difference of a colour between two pixels, of 255.
int difference(const uint8_t* a, const uint8_t* b);

}  // namespace ballpit
