// SPDX-License-Identifier: MIT
// Makes lines of overlays thinner where spheres are small, so that the lines do not hide the spheres.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "render/frame_view.h"
#include "render/projection.h"

namespace ballpit {

/// A factor for widths: 1, or less if the mean sphere is small in the picture. `unit`: 1/1080 of its height [pixel].
inline float line_scale(const FrameView& view, const Projection& projection, float unit) {
  constexpr float kFull = 24, kMin = 0.25f;  // the radius [unit] from which the factor is 1; the smallest factor
  const std::vector<float>& radius = view.inspection.bodies.radius;
  const Vec3 middle = (view.domain.min + view.domain.max) / 2.0f;
  if (radius.empty() || !projection.sees(middle)) return 1;
  const float mean = std::accumulate(radius.begin(), radius.end(), 0.0f) / static_cast<float>(radius.size());
  return std::clamp(projection.length_at(middle, mean) / (kFull * unit), kMin, 1.0f);
}

}  // namespace ballpit
