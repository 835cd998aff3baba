// SPDX-License-Identifier: MIT
#include "scene/read_sections.h"

#include <algorithm>

namespace ballpit {

namespace {

constexpr Limits kFraction{0.0, 1.0};

template <class T>
void set_if(T& target, const std::optional<T>& value) {
  if (value) target = *value;
}

/// Throws where the sphere's mass, computed from the density, leaves the range of float.
double checked_mass(const TableReader& reader, double radius, double density) {
  const double mass = sphere_mass(radius, density);
  if (kMass.contains(mass)) return mass;
  throw reader.error("radius", number_text(radius) + ", which makes a mass of " + number_text(mass) + " kg",
                     limits_text(kMass) + " kg");
}

void check_region(const TableReader& reader, const Domain& domain, const Fill& fill) {
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    const bool open = domain.boundary == Boundary::open_top && axis == 1;
    const std::string at = '[' + std::to_string(axis) + ']';
    if (fill.min[axis] < domain.min[axis]) {
      throw reader.error("min", number_text(fill.min[axis]) + " at " + at,
                         "at least " + number_text(domain.min[axis]) + ", the domain's");
    }
    if (fill.max[axis] > domain.max[axis] && !open) {
      throw reader.error("max", number_text(fill.max[axis]) + " at " + at,
                         "at most " + number_text(domain.max[axis]) + ", the domain's");
    }
    if (!(fill.min[axis] < fill.max[axis])) {
      throw reader.error(reader.has("max") ? "max" : "min",
                         number_text(fill.min[axis]) + " to " + number_text(fill.max[axis]) + " at " + at,
                         "min below max");
    }
  }
}

/// An option's value as it would be typed; empty for what cannot be typed.
std::optional<std::string> typed(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto number = whole_number(node)) return std::to_string(*number);  // also 1e5, for options that count
  if (node.is_number() || node.is_boolean()) return describe(node);
  return std::nullopt;
}

}  // namespace

Domain read_domain(const toml::table& table, const std::string& file) {
  constexpr std::string_view kKeys[] = {"min", "max", "boundary", "dimensions"};
  constexpr std::string_view kBoundaries[] = {"walls", "open-top", "periodic"};  // in the order of Boundary
  const TableReader reader(table, file, "[domain]", kKeys);
  Domain domain;
  domain.dimensions = static_cast<int>(reader.integer("dimensions", 2, 3).value_or(3));
  set_if(domain.min, reader.vector("min", domain.dimensions, kAnyNumber));
  set_if(domain.max, reader.vector("max", domain.dimensions, kAnyNumber));
  domain.boundary = static_cast<Boundary>(reader.choice("boundary", kBoundaries).value_or(0));
  if (domain.dimensions == 2) domain.min.z = domain.max.z = 0.0;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    if (domain.min[axis] < domain.max[axis]) continue;
    throw reader.error(
        reader.has("max") ? "max" : "min",
        number_text(domain.min[axis]) + " to " + number_text(domain.max[axis]) + " at [" + std::to_string(axis) + "]",
        "min below max");
  }
  return domain;
}

Physics read_physics(const toml::table& table, const std::string& file, int dimensions) {
  constexpr std::string_view kKeys[] = {"gravity", "restitution", "wall_restitution", "stiffness",
                                        "law",     "shear",       "initial_overlap",  "density"};
  constexpr std::string_view kLaws[] = {"linear", "hertz"};
  const TableReader reader(table, file, "[physics]", kKeys);
  Physics physics;
  set_if(physics.gravity, reader.vector("gravity", dimensions, kAnyNumber));
  set_if(physics.restitution, reader.number("restitution", kFraction));
  physics.wall_restitution = reader.number("wall_restitution", kFraction).value_or(physics.restitution);
  set_if(physics.stiffness, reader.number("stiffness", kPositive));
  physics.law = kLaws[reader.choice("law", kLaws).value_or(0)];
  set_if(physics.shear, reader.number("shear", kNotNegative));
  set_if(physics.initial_overlap, reader.number("initial_overlap", kFraction));
  set_if(physics.density, reader.number("density", kPositive));
  return physics;
}

Needs read_needs(const toml::table& table, const std::string& file) {
  constexpr std::string_view kKeys[] = {"duration", "max_overlap", "energy_tolerance", "momentum_tolerance",
                                        "max_speed"};
  const TableReader reader(table, file, "[needs]", kKeys);
  Needs needs;
  set_if(needs.duration, reader.number("duration", kNotNegative));
  needs.max_overlap = reader.number("max_overlap", kNotNegative);
  needs.energy_tolerance = reader.number("energy_tolerance", kNotNegative);
  needs.momentum_tolerance = reader.number("momentum_tolerance", kNotNegative);
  needs.max_speed = reader.number("max_speed", kNotNegative);
  return needs;
}

std::vector<DefaultOption> read_defaults(const toml::table& table, const std::string& file) {
  std::vector<DefaultOption> options;
  for (const auto& [key, node] : table) {
    const Place place{file, std::max(1, static_cast<int>(node.source().begin.line))};
    const std::string full_key = "[defaults] " + std::string(key.str());
    const std::optional<std::string> value = typed(node);
    if (!value) throw input_error(place, full_key, describe(node), "a number, a text in quotes, true or false");
    options.push_back({std::string(key.str()), *value, file + ':' + std::to_string(place.line) + ": " + full_key});
  }
  return options;
}

void read_sphere(const toml::table& table, const Domain& domain, const Physics& physics, SphereLines& lines,
                 Bodies& bodies) {
  constexpr std::string_view kKeys[] = {"position", "velocity", "radius", "mass"};
  const TableReader reader(table, lines.file, "[[spheres]]", kKeys);
  const std::optional<Vec3d> position = reader.vector("position", domain.dimensions, kAnyNumber);
  const std::optional<double> radius = reader.number("radius", kPositive);
  if (!position) throw reader.missing("position", "the centre of the sphere, [x, y, z]");
  if (!radius) throw reader.missing("radius", limits_text(kPositive));
  const std::optional<double> mass = reader.number("mass", kMass);
  bodies.position.push_back(*position);
  bodies.velocity.push_back(reader.vector("velocity", domain.dimensions, kAnyNumber).value_or(Vec3d(0.0)));
  bodies.radius.push_back(*radius);
  bodies.mass.push_back(mass ? *mass : checked_mass(reader, *radius, physics.density));
  lines.line.push_back(reader.place("position").line);
}

Fill read_fill(const toml::table& table, const std::string& file, const Domain& domain, const Physics& physics) {
  constexpr std::string_view kKeys[] = {"count", "radius", "speed", "velocity", "min", "max", "arrangement", "mass"};
  constexpr std::string_view kArrangements[] = {"random", "lattice"};  // in the order of Arrangement
  const TableReader reader(table, file, "[[fill]]", kKeys);
  const std::optional<int64_t> count = reader.integer("count", 0, kLargestCount);
  const std::optional<Limits> radius = reader.range("radius", kPositive);
  if (!count) throw reader.missing("count", "an integer, 0 to " + std::to_string(kLargestCount));
  if (!radius) throw reader.missing("radius", "a number, or an array of 2 numbers, low and high");
  Fill fill;
  fill.count = *count;
  fill.radius_min = radius->low;
  fill.radius_max = radius->high;
  fill.speed = reader.number("speed", kNotNegative).value_or(0.0);
  fill.velocity = reader.vector("velocity", domain.dimensions, kAnyNumber);
  if (fill.velocity && reader.has("speed")) throw reader.error("speed", "both speed and velocity", "one of them");
  fill.mass = reader.number("mass", kMass);
  if (!fill.mass) {
    checked_mass(reader, fill.radius_min, physics.density);
    checked_mass(reader, fill.radius_max, physics.density);
  }
  fill.min = reader.vector("min", domain.dimensions, kAnyNumber).value_or(domain.min);
  fill.max = reader.vector("max", domain.dimensions, kAnyNumber).value_or(domain.max);
  check_region(reader, domain, fill);
  fill.arrangement = static_cast<Arrangement>(reader.choice("arrangement", kArrangements).value_or(0));
  fill.place = reader.place("count");
  return fill;
}

}  // namespace ballpit
