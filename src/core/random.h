// SPDX-License-Identifier: MIT
// Seeded random numbers that are equal on every platform: only integer arithmetic and IEEE-exact operations on doubles
// (+, −, ×, ÷, √), so no distribution of <random>, no sin and no cos.
// Source: SplitMix64 (Steele, Lea, Flood 2014, doi 10.1145/2660193.2660195).
#pragma once

#include <cmath>
#include <cstdint>

#include "core/host_device.h"
#include "core/math.h"

namespace ballpit {

/// Mixes 64 bits, so that each input bit changes all output bits.
HOST_DEVICE inline uint64_t mix_bits(uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  /// The next 64 random bits.
  uint64_t bits() { return mix_bits(state_ += 0x9E3779B97F4A7C15u); }

  /// Uniform in [0, 1), a multiple of 2⁻⁵³.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform in the box [low, high), component by component in the order x, y, z.
  Vec3d uniform(const Vec3d& low, const Vec3d& high) {
    return {uniform(low.x, high.x), uniform(low.y, high.y), uniform(low.z, high.z)};  // braces keep the order
  }

  /// A unit vector of uniform direction, planar for `dimensions` 2. Draws a point in the ball and normalises it.
  Vec3d direction(int dimensions) {
    for (;;) {
      Vec3d v = uniform(Vec3d(-1.0), Vec3d(1.0));
      if (dimensions == 2) v.z = 0.0;
      const double squared = v.x * v.x + v.y * v.y + v.z * v.z;
      if (squared <= 1.0 && squared > 1e-6) return v / std::sqrt(squared);
    }
  }

 private:
  uint64_t state_;
};

}  // namespace ballpit
