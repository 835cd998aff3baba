// SPDX-License-Identifier: MIT
// Which of many small spheres are seen. A software renderer takes some microseconds for a sphere of eight pixels'
// radius, hidden or not, but 0.1 µs are enough to find out: nearer spheres first, a bit for each pixel that they cover completely.
#pragma once

#include <cstdint>
#include <vector>

#include "render/frame_view.h"

namespace ballpit {

struct SmallSpheres {
  std::vector<float> position;  ///< [m] three for each
  std::vector<float> radius;    ///< [m] one for all, or one each
};

/// What of them is drawn.
struct SeenSpheres {
  std::vector<uint32_t> nearest_first;  ///< numbers of those of which a pixel may be seen
  std::vector<Vec4> near_floor;         ///< [m] centre and radius of those with a shadow of which a pixel may be seen
};

/// In a picture of this size [pixel]. Drawing only these instead of all changes no pixel.
SeenSpheres find_seen(const SmallSpheres& spheres, const FrameView& view, int width, int height);

}  // namespace ballpit
