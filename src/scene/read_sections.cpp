// SPDX-License-Identifier: MIT
#include "scene/read_sections.h"

#include <fmt/format.h>

namespace ballpit {

namespace {

constexpr Limits kFraction{0.0, 1.0};

template <class T>
void set_if(T& target, const std::optional<T>& value) {
  if (value) target = *value;
}

void check_order(const TableReader& reader, const Vec3d& min, const Vec3d& max, int axis) {
  if (min[axis] < max[axis]) return;
  throw reader.error(reader.has("max") ? "max" : "min",
                     fmt::format("{} at [{}]", limits_text({min[axis], max[axis]}), axis), "min below max");
}

void check_region(const TableReader& reader, const Domain& domain, const Fill& fill) {
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    const bool open = domain.boundary == Boundary::open_top && axis == 1;
    if (fill.min[axis] < domain.min[axis]) {
      throw reader.error("min", fmt::format("{} at [{}]", number_text(fill.min[axis]), axis),
                         fmt::format("at least {}, the domain's", number_text(domain.min[axis])));
    }
    if (fill.max[axis] > domain.max[axis] && !open) {
      throw reader.error("max", fmt::format("{} at [{}]", number_text(fill.max[axis]), axis),
                         fmt::format("at most {}, the domain's", number_text(domain.max[axis])));
    }
    check_order(reader, fill.min, fill.max, axis);
  }
}

/// An option's value as it would be typed; empty for values that cannot be typed.
std::optional<std::string> typed(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto number = whole_number(node)) return std::to_string(*number);  // also 1e5, for options that count
  if (node.is_number() || node.is_boolean()) return describe(node);
  return std::nullopt;
}

Fill read_fill(const TableReader& reader, const Domain& domain, const Physics& physics) {
  constexpr std::string_view kArrangements[] = {"random", "lattice"};  // in the order of Arrangement
  const std::optional<int64_t> count = reader.integer("count", 0, kLargestCount);
  const std::optional<Limits> radius = reader.range("radius", kPositive);
  if (!count) throw reader.missing("count", fmt::format("an integer, 0 to {}", kLargestCount));
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
    for (const double r : {fill.radius_min, fill.radius_max}) {
      default_mass(r, physics.density, reader.place("radius"), "[[fill]] radius");
    }
  }
  fill.min = reader.vector("min", domain.dimensions, kAnyNumber).value_or(domain.min);
  fill.max = reader.vector("max", domain.dimensions, kAnyNumber).value_or(domain.max);
  check_region(reader, domain, fill);
  fill.arrangement = static_cast<Arrangement>(reader.choice("arrangement", kArrangements).value_or(0));
  fill.place = reader.place("count");
  return fill;
}

}  // namespace

Domain read_domain(const TableReader& root) {
  constexpr std::string_view kBoundaries[] = {"walls", "open-top", "periodic"};  // in the order of Boundary
  Domain domain;
  const auto reader = root.section("domain", {"min", "max", "boundary", "dimensions"});
  domain.dimensions = static_cast<int>(reader.integer("dimensions", 2, 3).value_or(3));
  set_if(domain.min, reader.vector("min", domain.dimensions, kAnyNumber));
  set_if(domain.max, reader.vector("max", domain.dimensions, kAnyNumber));
  domain.boundary = static_cast<Boundary>(reader.choice("boundary", kBoundaries).value_or(0));
  if (domain.dimensions == 2) domain.min.z = domain.max.z = 0.0;
  for (int axis = 0; axis < domain.dimensions; ++axis) check_order(reader, domain.min, domain.max, axis);
  return domain;
}

Physics read_physics(const TableReader& root, int dimensions) {
  constexpr std::string_view kLaws[] = {"linear", "hertz"};
  Physics physics;
  const auto reader = root.section("physics", {"gravity", "restitution", "wall_restitution", "stiffness", "law",
                                               "shear", "initial_overlap", "density"});
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

std::optional<Extent> read_view(const TableReader& root, const Domain& domain) {
  const auto reader = root.section("view", {"min", "max"});
  if (!root.has("view")) return std::nullopt;
  const Extent view{reader.vector("min", domain.dimensions, kAnyNumber).value_or(domain.min),
                    reader.vector("max", domain.dimensions, kAnyNumber).value_or(domain.max)};
  for (int axis = 0; axis < domain.dimensions; ++axis) check_order(reader, view.min, view.max, axis);
  return view;
}

Needs read_needs(const TableReader& root) {
  Needs needs;
  const auto reader =
      root.section("needs", {"duration", "max_overlap", "max_overlap_ever", "energy_tolerance", "momentum_tolerance",
                             "max_speed", "path_tolerance", "effects", "observables"});
  needs.are_declared = root.has("needs");
  set_if(needs.duration, reader.number("duration", kNotNegative));
  needs.max_overlap = reader.number("max_overlap", kNotNegative);
  needs.max_overlap_ever = reader.number("max_overlap_ever", kNotNegative);
  needs.energy_tolerance = reader.number("energy_tolerance", kNotNegative);
  needs.momentum_tolerance = reader.number("momentum_tolerance", kNotNegative);
  needs.max_speed = reader.number("max_speed", kNotNegative);
  needs.path_tolerance = reader.number("path_tolerance", kNotNegative);
  for (const size_t effect : reader.choices("effects", kEffectNames)) {
    if (!needs.has(static_cast<Effect>(effect))) needs.effects.push_back(static_cast<Effect>(effect));
  }
  if (needs.path_tolerance && !needs.has(Effect::paths)) needs.effects.push_back(Effect::paths);
  const auto wanted = reader.section("observables", {});
  for (const auto& [key, node] : wanted.table()) {
    const std::string name(key.str());
    const double tolerance = *wanted.number(name, kNotNegative);
    const Place place = wanted.place(name);
    needs.observables.push_back(
        {name, tolerance, fmt::format("{}:{}: [needs.observables] {}", place.file, place.line, name)});
  }
  return needs;
}

std::string read_because(const TableReader& root) { return root.section("defaults", {}).text("because").value_or(""); }

std::vector<DefaultOption> read_defaults(const TableReader& root, std::string_view section) {
  std::vector<DefaultOption> options;
  const auto reader = root.section(section, {});
  for (const auto& [key, node] : reader.table()) {
    const std::string name(key.str());
    if (section == "defaults" && name == "because") continue;  // read_because()
    const std::optional<std::string> value = typed(node);
    if (!value) throw reader.error(name, describe(node), "a number, a text in quotes, true or false");
    const Place place = reader.place(name);
    options.push_back({name, *value, fmt::format("{}:{}: [{}] {}", place.file, place.line, section, name)});
  }
  return options;
}

SphereLines read_spheres(const TableReader& root, Scene& scene) {
  SphereLines lines{root.file(), {}};
  const int dimensions = scene.domain.dimensions;
  Bodies& bodies = scene.bodies;
  for (const toml::table* table : root.tables("spheres")) {
    const TableReader reader = root.nested(*table, "[[spheres]]", {"position", "velocity", "radius", "mass"});
    const std::optional<Vec3d> position = reader.vector("position", dimensions, kAnyNumber);
    const std::optional<double> radius = reader.number("radius", kPositive);
    if (!position) throw reader.missing("position", "the centre of the sphere, [x, y, z]");
    if (!radius) throw reader.missing("radius", limits_text(kPositive));
    const std::optional<double> mass = reader.number("mass", kMass);
    bodies.position.push_back(*position);
    bodies.velocity.push_back(reader.vector("velocity", dimensions, kAnyNumber).value_or(Vec3d(0.0)));
    bodies.radius.push_back(*radius);
    bodies.mass.push_back(
        mass ? *mass : default_mass(*radius, scene.physics.density, reader.place("radius"), "[[spheres]] radius"));
    lines.line.push_back(reader.place("position").line);
  }
  return lines;
}

std::vector<Fill> read_fills(const TableReader& root, const Scene& scene) {
  std::vector<Fill> fills;
  for (const toml::table* table : root.tables("fill")) {
    const TableReader reader =
        root.nested(*table, "[[fill]]", {"count", "radius", "speed", "velocity", "min", "max", "arrangement", "mass"});
    fills.push_back(read_fill(reader, scene.domain, scene.physics));
  }
  return fills;
}

}  // namespace ballpit
