// SPDX-License-Identifier: MIT
// Errors in scene and CSV files, and the limits of all numbers in them.
#pragma once

#include <numbers>

#include "core/error.h"
#include "core/numbers.h"

namespace ballpit {

/// A closed range of numbers.
struct Limits {
  double low;
  double high;
  bool contains(double value) const { return value >= low && value <= high; }  // false for NaN
};

// Within these limits, squares of lengths and products with masses stay in the range of float.
inline constexpr Limits kAnyNumber{-1e15, 1e15};
inline constexpr Limits kNotNegative{0.0, 1e15};
inline constexpr Limits kPositive{1e-12, 1e15};
inline constexpr Limits kMass{1e-30, 1e30};            // [kg]
inline constexpr int64_t kLargestCount = 100'000'000;  // spheres

/// A place in a file.
struct Place {
  std::string file;
  int line = 1;
};

/// "scene.toml:3: [physics] restitution: found 1.5, allowed 0 to 1", with control characters made visible.
UserError input_error(const Place& place, std::string_view key, std::string_view found, std::string_view allowed);

/// `text` with control characters, and bytes that are not UTF-8, as \xNN: they would break the line or the terminal.
std::string visible(std::string_view text);

/// "0 to 1".
std::string limits_text(const Limits& limits);

/// `text` in quotes, shortened if long.
std::string in_quotes(std::string_view text);

/// [kg] of a sphere, also in planar scenes: a disc is a sphere that moves in a plane.
inline double sphere_mass(double radius, double density) {
  return density * (4.0 / 3.0 * std::numbers::pi) * radius * radius * radius;
}

/// sphere_mass() for a sphere without a mass in its file. Throws UserError about its radius if the mass is outside of kMass.
double default_mass(double radius, double density, const Place& place, std::string_view key);

}  // namespace ballpit
