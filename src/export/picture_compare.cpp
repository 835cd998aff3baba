// SPDX-License-Identifier: MIT
#include "export/picture_compare.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <vector>

namespace ballpit {

namespace {

constexpr std::array<uint8_t, 3> kMark{0xD5, 0x5E, 0x00};  // as a missed contact: visual.md's colour of what is wrong

uint8_t* pixel_of(Image& image, int x, int y) { return const_cast<uint8_t*>(image.pixel(x, y)); }

/// Whether one of the 3 × 3 pixels around a place is like `pixel`. The place itself comes first: it mostly is.
bool has_like(const Image& image, int x, int y, const uint8_t* pixel) {
  if (difference(image.pixel(x, y), pixel) <= kMaxChannelDifference) return true;
  for (int v = std::max(0, y - 1); v <= std::min(image.height - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(image.width - 1, x + 1); ++u) {
      if (difference(image.pixel(u, v), pixel) <= kMaxChannelDifference) return true;
    }
  }
  return false;
}

bool differs(const Image& a, const Image& b, int x, int y) {
  return !has_like(b, x, y, a.pixel(x, y)) || !has_like(a, x, y, b.pixel(x, y));
}

/// The second picture, pale, with marks. A mark covers the neighbours too: a single pixel could not be seen.
Image marked(const Image& a, const Image& b) {
  Image picture = b;
  for (size_t k = 0; k < picture.pixels.size(); ++k) {
    if (k % 4 != 3) picture.pixels[k] = static_cast<uint8_t>(192 + picture.pixels[k] / 4);
  }
  for (int y = 0; y < b.height; ++y) {
    for (int x = 0; x < b.width; ++x) {
      if (!differs(a, b, x, y)) continue;
      for (int v = std::max(0, y - 1); v <= std::min(b.height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(b.width - 1, x + 1); ++u) {
          std::copy(kMark.begin(), kMark.end(), pixel_of(picture, u, v));
        }
      }
    }
  }
  return picture;
}

/// Pictures in a row from left to right, aligned at the top, on grey.
Image side_by_side(std::span<const Image> pictures) {
  constexpr int kGap = 8;  // [px]
  Image row;
  row.width = -kGap;
  for (const Image& picture : pictures) {
    row.width += picture.width + kGap;
    row.height = std::max(row.height, picture.height);
  }
  row.pixels.assign(static_cast<size_t>(row.width) * static_cast<size_t>(row.height) * 4, 128);
  int left = 0;
  for (const Image& picture : pictures) {
    for (int y = 0; y < picture.height; ++y) {
      std::copy_n(picture.pixel(0, y), static_cast<size_t>(picture.width) * 4, pixel_of(row, left, y));
    }
    left += picture.width + kGap;
  }
  return row;
}

}  // namespace

int difference(const uint8_t* a, const uint8_t* b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

Comparison comparison_of(const Image& a, const Image& b) {
  Comparison found;
  for (int top = 0; top < a.height; top += kCompareBlock) {
    for (int left = 0; left < a.width; left += kCompareBlock) {
      int count = 0;
      for (int y = top; y < std::min(top + kCompareBlock, a.height); ++y) {
        for (int x = left; x < std::min(left + kCompareBlock, a.width); ++x) {
          found.largest = std::max(found.largest, difference(a.pixel(x, y), b.pixel(x, y)));
          count += differs(a, b, x, y);
        }
      }
      found.differing += count;
      if (count <= found.worst_block) continue;
      found.worst_block = count;
      found.left = left;
      found.top = top;
    }
  }
  return found;
}

Image comparison_picture(const Image& a, const Image& b) {
  std::vector<Image> pictures{a, b};
  if (a.width == b.width && a.height == b.height) pictures.push_back(marked(a, b));
  return side_by_side(pictures);
}

}  // namespace ballpit
