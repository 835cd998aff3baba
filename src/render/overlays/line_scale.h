// SPDX-License-Identifier: MIT
// How wide lines of overlays may be: in a crowd, they must not hide the spheres.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "render/frame_view.h"
#include "render/projection.h"

namespace ballpit {

/// A factor of widths: 1, or less where the mean sphere is small in the picture. `unit`: 1/1080 of its height [pixel].
inline float line_scale(const FrameView& view, const Projection& projection, float unit) {
  constexpr float kFull = 24, kLeast = 0.25f;  // from this radius on [unit]; the smallest factor
  const std::vector<float>& radius = view.inspection.bodies.radius;
  const Vec3 middle = (view.domain.min + view.domain.max) / 2.0f;
  if (radius.empty() || !projection.sees(middle)) return 1;
  const float mean = std::accumulate(radius.begin(), radius.end(), 0.0f) / static_cast<float>(radius.size());
  return std::clamp(projection.length_at(middle, mean) / (kFull * unit), kLeast, 1.0f);
}

}  // namespace ballpit
