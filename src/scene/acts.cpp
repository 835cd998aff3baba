// SPDX-License-Identifier: MIT
#include "scene/acts.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/file.h"
#include "scene/table_reader.h"

namespace ballpit {

namespace {

constexpr double kRounding = 1e-6;  // of a radius: how far a sphere may reach into a wall

std::string text_of(const Vec3d& v, int dimensions) {
  std::string text;
  for (int axis = 0; axis < dimensions; ++axis) append_number(text += axis > 0 ? ", " : "", v[axis]);
  return "[" + text + "]";
}

/// What the acts before have made of the scene.
struct Stage {
  const Scene& scene;
  const Bodies& bodies;
  int64_t count;    // spheres
  double time = 0;  // [s] of the act before
};

/// Throws UserError for a key that another act has.
void reject_other_keys(const TableReader& reader, ActKind kind) {
  const auto only_for = [&](std::string_view key, ActKind owner) {
    if (kind == owner || !reader.has(key)) return;
    throw reader.error(key, describe(*reader.table().get(key)),
                       fmt::format("only with act = \"{}\"", kActNames[size_t(owner)]));
  };
  only_for("reach", ActKind::push);
  only_for("radius", ActKind::drop);
  only_for("mass", ActKind::drop);
}

double read_time(const TableReader& reader, double before) {
  constexpr double kLatest = 1e9;  // [s]
  const std::optional<double> time = reader.number("time", {0, kLatest});
  if (!time) throw reader.missing("time", limits_text({0, kLatest}));
  if (*time >= before) return *time;
  throw reader.error("time", number_text(*time), number_text(before) + ", the time of the act before, or more");
}

int64_t read_sphere(const TableReader& reader, ActKind kind, int64_t count) {
  if (kind == ActKind::drop) return reader.integer("sphere", count, count).value_or(count);
  if (count == 0) {
    const toml::node* const found = reader.table().get("sphere");
    throw reader.error("sphere", found ? describe(*found) : "nothing", "a drop before it: there is no sphere yet");
  }
  const std::optional<int64_t> sphere = reader.integer("sphere", 0, count - 1);
  if (!sphere) throw reader.missing("sphere", fmt::format("an integer, 0 to {}", count - 1));
  return *sphere;
}

/// The largest radius [m] for which two spheres touch in one place only, and one fits between the walls.
double largest_radius(const Domain& domain) {
  double edge = domain.max.x - domain.min.x;
  for (int axis = 1; axis < domain.dimensions; ++axis) edge = std::min(edge, domain.max[axis] - domain.min[axis]);
  return edge / (domain.boundary == Boundary::periodic ? 4 : 2);
}

void read_dropped(const TableReader& reader, const Stage& stage, Act& act) {
  const Domain& domain = stage.scene.domain;
  const SphereSize typical = typical_sphere(stage.scene, stage.bodies);
  const std::optional<double> radius = reader.number("radius", {kPositive.low, largest_radius(domain)});
  act.radius = radius.value_or(typical.radius);
  const double ratio = act.radius / typical.radius;
  act.mass = reader.number("mass", kMass).value_or(typical.mass * ratio * ratio * ratio);
  if (fits_inside(domain, act.vector, act.radius)) return;
  throw reader.error(
      "vector",
      fmt::format("a sphere of radius {} at {}", number_text(act.radius), text_of(act.vector, domain.dimensions)),
      fmt::format("inside of the domain, {} to {}", text_of(domain.min, domain.dimensions),
                  text_of(domain.max, domain.dimensions)));
}

Act read_act(const TableReader& reader, Stage& stage) {
  const int dimensions = stage.scene.domain.dimensions;
  Act act;
  act.time = stage.time = read_time(reader, stage.time);
  const std::optional<size_t> kind = reader.choice("act", kActNames);
  if (!kind) throw reader.missing("act", join(kActNames));
  act.kind = static_cast<ActKind>(*kind);
  reject_other_keys(reader, act.kind);
  act.sphere = read_sphere(reader, act.kind, stage.count);
  const std::optional<Vec3d> vector = reader.vector("vector", dimensions, kAnyNumber);
  if (!vector) throw reader.missing("vector", dimensions == 2 ? "an array of 2 or 3 numbers" : "an array of 3 numbers");
  act.vector = *vector;
  if (act.kind == ActKind::drop) {
    read_dropped(reader, stage, act);
    ++stage.count;
  } else if (act.kind == ActKind::push) {
    const bool is_dropped = act.sphere >= stage.bodies.size();
    const double radius = is_dropped ? typical_sphere(stage.scene, stage.bodies).radius
                                     : stage.bodies.radius[static_cast<size_t>(act.sphere)];
    act.reach = reader.number("reach", kNotNegative).value_or(kHandful * radius);
  }
  return act;
}

}  // namespace

SphereSize typical_sphere(const Scene& scene, const Bodies& bodies) {
  if (bodies.size() == 0) {
    constexpr double kPart = 0.1;  // of the largest that fits: a twentieth of the shortest edge
    const double radius = kPart * largest_radius(scene.domain);
    return {radius, sphere_mass(radius, scene.physics.density)};
  }
  std::vector<size_t> order(bodies.radius.size());
  std::iota(order.begin(), order.end(), size_t(0));
  const auto middle = order.begin() + std::ptrdiff_t(order.size() / 2);
  std::nth_element(order.begin(), middle, order.end(),
                   [&](size_t a, size_t b) { return std::pair(bodies.radius[a], a) < std::pair(bodies.radius[b], b); });
  return {bodies.radius[*middle], bodies.mass[*middle]};
}

bool fits_inside(const Domain& domain, const Vec3d& p, double radius) {
  const double free = domain.boundary == Boundary::periodic ? 0 : radius * (1 - kRounding);
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    const bool is_open = domain.boundary == Boundary::open_top && axis == 1;
    if (!(p[axis] - free >= domain.min[axis])) return false;
    if (!is_open && !(p[axis] + free <= domain.max[axis])) return false;
  }
  return true;
}

std::vector<Act> read_acts(const std::filesystem::path& path, const Scene& scene, const Bodies& bodies) {
  const toml::table root = parse_toml(read_file(path), path.string());
  const TableReader reader(root, path.string(), "", {"act"});
  Stage stage{scene, bodies, bodies.size()};
  std::vector<Act> acts;
  for (const toml::table* table : reader.tables("act")) {
    acts.push_back(read_act(
        reader.nested(*table, "[[act]]", {"time", "act", "sphere", "vector", "reach", "radius", "mass"}), stage));
  }
  return acts;
}

std::string text_of(const std::vector<Act>& acts, int dimensions, std::string_view comment) {
  std::string text(comment);
  const auto number = [&](std::string_view key, double value) {
    append_number(text += fmt::format("{} = ", key), value);
    text += '\n';
  };
  for (const Act& act : acts) {
    text += "\n[[act]]\n";
    number("time", act.time);
    text += fmt::format("act = \"{}\"\nsphere = {}\nvector = {}\n", kActNames[size_t(act.kind)], act.sphere,
                        text_of(act.vector, dimensions));
    if (act.kind == ActKind::push) number("reach", act.reach);
    if (act.kind != ActKind::drop) continue;
    number("radius", act.radius);
    number("mass", act.mass);
  }
  return text;
}

}  // namespace ballpit
