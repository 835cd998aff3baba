// SPDX-License-Identifier: MIT
// How well a colour can be told from the one behind it.
// Source: W3C, Web Content Accessibility Guidelines 2.1, "contrast ratio" and "relative luminance".
#pragma once

#include <algorithm>
#include <cmath>

#include "core/math.h"

namespace ballpit {

/// Marks that carry meaning have at least this contrast to what they are drawn on.
inline constexpr float kMinContrast = 3;

/// Of an encoded (sRGB) colour: 0 for black, 1 for white.
inline float luminance(const Vec3& color) {
  const auto linear = [](float c) { return c <= 0.03928f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
  return 0.2126f * linear(color.r) + 0.7152f * linear(color.g) + 0.0722f * linear(color.b);
}

/// 1 for equal colours, up to 21 for black on white.
inline float contrast(const Vec3& a, const Vec3& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05f) / (low + 0.05f);
}

/// The colour that is seen where a translucent one lies over another.
inline Vec3 blended(const Vec3& color, float opacity, const Vec3& ground) { return glm::mix(ground, color, opacity); }

/// The dark rim of a mark that is itself too similar to spheres or to a white ground: one of the two is visible on
/// each.
inline Vec3 rim_of(const Vec3& color) { return 0.4f * color; }

}  // namespace ballpit
