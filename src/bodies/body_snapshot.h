// SPDX-License-Identifier: MIT
// Copies of the bodies on the host for renderers and overlays, and memory for a world to write them to.
#pragma once

#include <vector>

#include "core/math.h"
#include "core/span.h"

namespace ballpit {

inline constexpr int kOccluders = 4;            ///< of each sphere, whose light is computed one by one
inline constexpr float kOcclusionReach = 1.5f;  ///< of the sum of two radii: spheres farther apart hide nothing
inline constexpr float kOcclusionFades = 1.2f;  ///< from where on they hide less, so that nothing appears suddenly

/// A sphere that hides a part of the sky from another one, in the layout of the vertex shader.
struct Occluder {
  Vec3 way{0.0f};    ///< [m] from the other sphere's centre to its own
  float radius = 0;  ///< [m]; 0 for none
  bool operator==(const Occluder&) const = default;
};

/// What hides the sky from a sphere, in the layout of the vertex shader.
struct Occluders {
  Occluder strongest[kOccluders];  ///< the strongest first
  Vec3 others_by_normal{0.0f};     ///< all others together hide, at a normal n, about the share
  float others = 0;                ///< others + dot(others_by_normal, n)
};

/// The bodies in the layout of the vertex shader: `dimensions` floats of position a body (a missing z is 0), and one
/// radius for all, or one each.
struct BodySnapshot {
  int64_t count = 0;
  int dimensions = 3;
  std::vector<float> position;       ///< [m] count × dimensions
  std::vector<float> velocity;       ///< [m/s] count × dimensions
  std::vector<float> radius;         ///< [m] 1 or count values
  std::vector<Occluders> occluders;  ///< one for each; empty unless wanted

  Vec3 position_of(int64_t i) const { return vector_at(position, i); }
  Vec3 velocity_of(int64_t i) const { return vector_at(velocity, i); }
  float radius_of(int64_t i) const { return radius.size() == 1 ? radius[0] : radius[static_cast<size_t>(i)]; }

 private:
  Vec3 vector_at(const std::vector<float>& values, int64_t i) const {
    const float* v = values.data() + i * dimensions;
    return {v[0], v[1], dimensions == 3 ? v[2] : 0.0f};
  }
};

/// The properties of the bodies that never change in a world: all but positions and velocities.
struct BodyShape {
  int64_t count = 0;
  int dimensions = 3;
  bool has_equal_radii = true;
  float radius = 0;    ///< [m] of all bodies, or the largest
  float smallest = 0;  ///< [m] radius
};

/// Memory on the world's own processor that a vertex shader reads, for bodies in the order of their ids.
struct BodyTarget {
  Span<float> position;         ///< [m] count × dimensions
  Span<float> radius;           ///< [m] count values; none if all are equal
  Span<uint8_t> touching;       ///< 1 for a body in contact, else 0
  Span<Occluders> occluders{};  ///< one for each; none if they are not wanted
};

}  // namespace ballpit
