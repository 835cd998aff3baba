// SPDX-License-Identifier: MIT
// A picture in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ballpit {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> pixels;  ///< width × height × RGBA, rows from top to bottom; frames are opaque

  const uint8_t* pixel(int x, int y) const {
    return pixels.data() + (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) * 4;
  }
};

}  // namespace ballpit
