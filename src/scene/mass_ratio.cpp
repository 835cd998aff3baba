// SPDX-License-Identifier: MIT
#include "scene/mass_ratio.h"

#include <set>

#include <fmt/format.h>

namespace ballpit {

namespace {

constexpr Limits kMassRatios{1, 1e12};

void set_mass_ratio(Bodies& bodies, double ratio, const Place& place, std::string_view key) {
  const std::set<double> masses(bodies.mass.begin(), bodies.mass.end());
  if (masses.size() != 2) {
    throw input_error(place, key, number_text(ratio),
                      fmt::format("only in a scene whose [[spheres]] have two masses, not {}", masses.size()));
  }
  const double light = *masses.begin(), heavy = ratio * light;
  if (!kMass.contains(heavy)) {
    throw input_error(place, key, fmt::format("{}, a mass of {:g} kg", number_text(ratio), heavy),
                      limits_text(kMass) + " kg");
  }
  for (double& mass : bodies.mass) {
    if (mass != light) mass = heavy;
  }
}

}  // namespace

void override_masses(const TableReader& root, std::optional<double> given, Bodies& bodies) {
  if (given) {
    set_mass_ratio(bodies, *given, root.place("spheres"), "--mass-ratio");
  } else if (const auto ratio = root.section("defaults", {}).number("mass-ratio", kMassRatios)) {
    set_mass_ratio(bodies, *ratio, root.place("defaults"), "[defaults] mass-ratio");
  }
}

}  // namespace ballpit
