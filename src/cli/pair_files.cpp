// SPDX-License-Identifier: MIT
#include "cli/pair_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>

#include <fmt/compile.h>

#include "scene/input_error.h"
#include "scene/read_scene.h"
#include "show/notes.h"
#include "show/options.h"

namespace ballpit {

namespace {

bool is_scene(const std::string& file) {
  if (file.ends_with(".toml")) return true;
  const auto scenes = built_in_scenes();
  const bool is_built_in =
      std::any_of(scenes.begin(), scenes.end(), [&](const SceneInfo& s) { return s.name == file; });
  std::error_code ignored;
  return is_built_in && !std::filesystem::exists(file, ignored);
}

/// Spheres and domain, rounded as a world in single precision rounds them.
PairInput from_scene(const std::string& file) {
  const Scene scene = load_scene(file);
  print_warnings(scene.notes);
  PairInput input;
  for (const Vec3d& p : scene.bodies.position) input.spheres.position.push_back(narrow<Vec3>(p));
  input.spheres.radius.assign(scene.bodies.radius.begin(), scene.bodies.radius.end());
  const Domain& domain = scene.domain;
  if (domain.boundary != Boundary::periodic) return input;
  input.period = domain.max - domain.min;
  input.box = Box<Vec3>{narrow<Vec3>(domain.min), narrow<Vec3>(domain.max), Boundary::periodic};
  if (domain.dimensions == 2) input.period->z = 0;
  return input;
}

struct AxisExtent {
  float low = 0, high = 0;
};

AxisExtent extent_along(int axis, const std::vector<Vec3>& position) {
  if (position.empty()) return {};
  const auto [low, high] = std::minmax_element(position.begin(), position.end(),
                                               [&](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
  return {(*low)[axis], (*high)[axis]};
}

/// Makes the period so long that no sphere reaches another across it.
void leave_open(int axis, const AxisExtent& extent, float radius, Box<Vec3>& box) {
  const double low = double(extent.low), high = double(extent.high);
  const double rounding = 8.0 * double(std::numeric_limits<float>::epsilon()) * std::max(std::abs(low), std::abs(high));
  const double gap = radius > 0 ? 4.5 * double(radius) + rounding : 1.0;
  box.min[axis] = extent.low;
  box.max[axis] = static_cast<float>(high + gap);
}

/// A domain of this period. It holds all spheres as they are if there is such a domain; else they are wrapped into it.
void lay_period(int axis, const AxisExtent& extent, double period, Box<Vec3>& box) {
  for (const double low : {0.0, -0.5 * period, double(extent.low), 0.0}) {
    box.min[axis] = static_cast<float>(low);
    box.max[axis] = static_cast<float>(low + period);
    if (extent.low >= box.min[axis] && extent.high < box.max[axis]) return;
  }
}

void check_period(int axis, double period, float radius) {
  if (period >= 4.0 * double(radius) * (1.0 - 1e-6)) return;
  throw UserError(
      "--period",
      fmt::format("{} along {} with radius {}", number_text(period), "xyz"[axis], number_text(double(radius))),
      "0 for none, or at least four radii, " + number_text(4.0 * double(radius)));
}

void wrap(const std::string& file, PairInput& input) {
  int64_t wrapped = 0;
  for (Vec3& p : input.spheres.position) {
    const Vec3 inside = input.box->wrap(p);
    wrapped += inside != p;
    p = inside;
  }
  if (wrapped == 0) return;
  warn(file, fmt::format("{} of {} spheres were outside of the period, and are at their images inside", wrapped,
                         input.spheres.size()));
}

}  // namespace

Vec3d parse_period(const std::string& text) {
  const std::vector<std::string> items = split_list(text);
  if (items.size() != 3) {
    throw UserError("--period", text, "X,Y,Z: three numbers, 0 for an axis without a period");
  }
  Vec3d period(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    period[axis] = parse_number("--period", items[static_cast<size_t>(axis)], Range{0.0, kAnyNumber.high});
  }
  return period;
}

PairInput read_pair_input(const std::string& file, const std::optional<Vec3d>& period) {
  PairInput input;
  if (is_scene(file)) {
    if (period) {
      throw UserError("--period", "with the scene " + file + ", which has its own period or none", "with a CSV file");
    }
    input = from_scene(file);
  } else {
    input.spheres = read_resting_spheres(LineReader(file));
    if (!input.spheres.note.empty()) print_warnings({input.spheres.note});
    if (period && *period != Vec3d(0.0)) {
      input.period = period;
      input.box = Box<Vec3>{{}, {}, Boundary::periodic};
    }
  }
  if (!input.period) return input;
  const std::vector<float>& radii = input.spheres.radius;
  const float radius = radii.empty() ? 0.0f : *std::max_element(radii.begin(), radii.end());
  for (int axis = 0; axis < 3; ++axis) {
    const double along = (*input.period)[axis];
    const AxisExtent extent = extent_along(axis, input.spheres.position);
    if (along == 0) {
      leave_open(axis, extent, radius, *input.box);
    } else if (period) {
      check_period(axis, along, radius);
      lay_period(axis, extent, along, *input.box);
    }
  }
  wrap(file, input);
  return input;
}

std::string pairs_csv(const std::vector<Pair>& pairs) {
  std::string text = "i,j\n";
  text.reserve(text.size() + 16 * pairs.size());
  for (const Pair& pair : pairs) fmt::format_to(std::back_inserter(text), FMT_COMPILE("{},{}\n"), pair.i, pair.j);
  return text;
}

}  // namespace ballpit
