// SPDX-License-Identifier: MIT
#include "scene/read_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/file.h"
#include "scene/mass_ratio.h"
#include "scene/read_sections.h"
#include "scene_files.h"

namespace ballpit {

namespace {

constexpr std::string_view kAxes = "xyz";

/// The value of initial_overlap that allows every overlap.
constexpr double kAnyOverlap = 1.0;

Place place_of(const SphereLines& lines, int64_t i) { return {lines.file, lines.line[static_cast<size_t>(i)]}; }

std::string key_of(const SphereLines& lines, int axis) {
  return lines.csv ? std::string(1, kAxes[static_cast<size_t>(axis)]) : fmt::format("[[spheres]] position[{}]", axis);
}

/// Whether x is in the domain, or in the domain rounded to single precision, whose positions must be read back unchanged.
bool is_in_period(const Domain& domain, int axis, double x) {
  const double low = domain.min[axis], high = domain.max[axis];
  return (x >= low && x < high) || (x >= double(static_cast<float>(low)) && x < double(static_cast<float>(high)));
}

/// The image of x in [min, max).
double wrapped(const Domain& domain, int axis, double x) {
  const double low = domain.min[axis], period = domain.max[axis] - low;
  x -= period * std::floor((x - low) / period);
  return x >= low && x < domain.max[axis] ? x : low;
}

/// [m] By how much rounding to single precision may move two spheres towards each other, or one towards a wall.
double rounding_at(const Domain& domain, const Vec3d& p) {
  const Vec3d largest = glm::max(glm::abs(p), glm::max(glm::abs(domain.min), glm::abs(domain.max)));
  return 2.0 * double(std::numeric_limits<float>::epsilon()) * std::max({largest.x, largest.y, largest.z});
}

void check_walls(const Domain& domain, const SphereLines& lines, int64_t i, int axis, double x, double radius,
                 double tolerance) {
  const bool open = domain.boundary == Boundary::open_top && axis == 1;
  const bool below = x - radius < domain.min[axis] - tolerance;
  const bool above = x + radius > domain.max[axis] + tolerance;
  if (!below && (!above || open)) return;
  throw input_error(
      place_of(lines, i), key_of(lines, axis),
      fmt::format("sphere {} reaching from {}", i, limits_text({x - radius, x + radius})),
      (open ? "above " + number_text(domain.min[axis]) : limits_text({domain.min[axis], domain.max[axis]})) +
          ", the domain");
}

/// Returns whether it has moved sphere i from outside of a periodic domain to its image inside.
bool check_inside(const Domain& domain, const Physics& physics, const SphereLines& lines, int64_t i, Bodies& bodies) {
  const auto k = static_cast<size_t>(i);
  bool was_outside = false;
  if (domain.dimensions == 2) bodies.position[k].z = bodies.velocity[k].z = 0.0;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    if (domain.boundary == Boundary::periodic) {
      double& x = bodies.position[k][axis];
      if (is_in_period(domain, axis, x)) continue;
      was_outside |= x != domain.max[axis];  // max is the same point as min
      x = wrapped(domain, axis, x);
    } else {
      check_walls(domain, lines, i, axis, bodies.position[k][axis], bodies.radius[k],
                  physics.initial_overlap * bodies.radius[k] + rounding_at(domain, bodies.position[k]));
    }
  }
  return was_outside;
}

[[noreturn]] void fail_overlap(const SphereLines& lines, int64_t i, int64_t j, double overlap, double smaller,
                               double allowed) {
  throw input_error(place_of(lines, j), lines.csv ? "x" : "[[spheres]] position",
                    fmt::format("spheres {} (line {}) and {} overlapping by {} m, {} of the smaller radius", i,
                                place_of(lines, i).line, j, number_text(overlap), number_text(overlap / smaller)),
                    number_text(allowed) + ", see [physics] initial_overlap");
}

/// Makes `bodies` fit `domain`: removes the third dimension in planar scenes, and moves centres outside of a periodic domain to
/// their images inside. Throws UserError for the first sphere that overlaps a wall by more than physics.initial_overlap ·
/// radius, and for a pair that overlaps by more than that fraction of the smaller radius, unless it is kAnyOverlap. Adds all
/// spheres to `index`. Returns how many were outside of a periodic domain.
int64_t check_spheres(const Domain& domain, const Physics& physics, const SphereLines& lines, Bodies& bodies,
                      SphereIndex& index) {
  int64_t wrapped = 0;
  for (int64_t i = 0; i < bodies.size(); ++i) wrapped += check_inside(domain, physics, lines, i, bodies);
  const bool may_overlap = physics.initial_overlap >= kAnyOverlap;

  // The largest first: each search then visits only spheres of its own size or larger, and few of these are within reach.
  for (const int32_t i : by_descending_radius(bodies.radius, 0, bodies.size())) {
    const auto k = static_cast<size_t>(i);
    const double radius = bodies.radius[k];
    index.visit_near(bodies.position[k], radius, 0.0, [&](const SphereIndex::Sphere& other, double distance2) {
      const double overlap = radius + other.radius - std::sqrt(distance2);
      if (may_overlap) return false;
      if (overlap <= physics.initial_overlap * radius + rounding_at(domain, bodies.position[k])) return false;
      const auto [first, second] = std::minmax(i, other.id);
      fail_overlap(lines, first, second, overlap, radius, physics.initial_overlap);
    });
    index.insert(i, bodies.position[k], radius);
  }
  return wrapped;
}

/// Throws UserError unless each edge of a periodic domain is at least four times the largest radius, so that two spheres touch
/// across one edge only. `place` is the domain's in the file.
void check_periodic_edges(const Domain& domain, double largest_radius, const Place& place) {
  if (domain.boundary != Boundary::periodic) return;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    const double edge = domain.max[axis] - domain.min[axis];
    // The difference of two rounded numbers has their rounding errors: 0.3 − 0.1 < 0.2.
    const double rounding = 2.0 * std::numeric_limits<double>::epsilon() *
                            std::max({std::abs(domain.min[axis]), std::abs(domain.max[axis]), 4.0 * largest_radius});
    if (edge >= 4.0 * largest_radius - rounding) continue;
    throw input_error(place, "[domain] max",
                      fmt::format("an edge of {} along {} with radius {}", number_text(edge),
                                  kAxes[static_cast<size_t>(axis)], number_text(largest_radius)),
                      fmt::format("at least four radii, {}, in a periodic domain", number_text(4.0 * largest_radius)));
  }
}

TableReader reader_of(const toml::table& root, std::string_view file_name) {
  const TableReader::Keys keys{"title",   "description", "title_de", "description_de", "domain", "physics",
                               "spheres", "fill",        "defaults", "needs",          "view"};
  return {root, std::string(file_name), "", keys};
}

SceneInfo read_info(const TableReader& root) {
  SceneInfo info;
  info.name = std::filesystem::path(root.file()).stem().string();
  info.title = root.text("title").value_or(info.name);
  info.description = root.text("description").value_or("");
  info.title_de = root.text("title_de").value_or(info.title);
  info.description_de = root.text("description_de").value_or(info.description);
  return info;
}

/// `spheres = "file.csv"` or tables [[spheres]].
SphereLines read_listed_spheres(const TableReader& root, const std::filesystem::path& folder, Scene& scene) {
  const toml::node* node = root.table().get("spheres");
  if (node == nullptr || node->is_array()) return read_spheres(root, scene);
  if (!node->is_string()) {
    throw root.error("spheres", describe(*node), "tables [[spheres]], or the name of a CSV file");
  }
  const std::filesystem::path path = folder / node->as_string()->get();
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw root.error("spheres", describe(*node) + ", but no such file", "a CSV file beside the scene");
  }
  SphereLines lines;
  scene.bodies = read_spheres_csv(path, scene.physics.density, &lines);
  if (!lines.note.empty()) scene.notes.push_back(lines.note);
  return lines;
}

/// An integer of [defaults] that the reader of the scene needs itself.
std::optional<int64_t> default_integer(const TableReader& root, std::string_view key, int64_t high) {
  return root.section("defaults", {}).integer(key, 0, high);
}

/// Distributes `total` in proportion to the counts; the first fills get the rest from rounding.
void scale_counts(std::vector<Fill>& fills, int64_t total) {
  double sum = 0.0;
  for (const Fill& fill : fills) sum += static_cast<double>(fill.count);
  int64_t left = total;
  for (Fill& fill : fills) {
    const double share = sum > 0.0 ? static_cast<double>(fill.count) / sum : 1.0 / static_cast<double>(fills.size());
    fill.count = std::min(left, static_cast<int64_t>(share * static_cast<double>(total)));
    left -= fill.count;
  }
  for (size_t k = 0; left > 0; k = (k + 1) % fills.size(), --left) ++fills[k].count;
}

/// `key` is "--count" or "[defaults] count"; errors about the fills then name it too.
void override_count(std::vector<Fill>& fills, int64_t count, const Place& place, const std::string& key) {
  const std::string found = std::to_string(count);
  if (count < 0 || count > kLargestCount) throw input_error(place, key, found, fmt::format("0 to {}", kLargestCount));
  if (fills.empty()) throw input_error(place, key, found, "only in a scene with a [[fill]]");
  scale_counts(fills, count);
  for (Fill& fill : fills) fill.count_key = fmt::format("[[fill]] count ({})", key);
}

std::vector<Fill> read_counted_fills(const TableReader& root, const Scene& scene, const SceneOverrides& overrides) {
  std::vector<Fill> fills = read_fills(root, scene);
  if (overrides.count) {
    override_count(fills, *overrides.count, root.place("fill"), "--count");
  } else if (const auto count = default_integer(root, "count", kLargestCount)) {
    override_count(fills, *count, root.place("defaults"), "[defaults] count");
  }
  int64_t total = scene.bodies.size();
  for (const Fill& fill : fills) {
    total += fill.count;
    if (total <= kLargestCount) continue;
    throw input_error(fill.place, fill.count_key, fmt::format("{} spheres altogether", total),
                      fmt::format("at most {}", kLargestCount));
  }
  return fills;
}

double largest_radius(const Bodies& bodies, const std::vector<Fill>& fills) {
  double largest = 0.0;
  for (const double radius : bodies.radius) largest = std::max(largest, radius);
  for (const Fill& fill : fills) {
    if (fill.count > 0) largest = std::max(largest, fill.radius_max);
  }
  return largest;
}

/// The values of the file, without spheres.
Scene read_values(const TableReader& root, const SceneOverrides& overrides) {
  Scene scene;
  static_cast<SceneInfo&>(scene) = read_info(root);
  scene.domain = read_domain(root);
  if (!root.has("domain")) {
    scene.notes.push_back(root.file() +
                          ": found no [domain]: it is a cube of 1 m with walls, from 0 to 1 along each axis");
  }
  scene.physics = read_physics(root, scene.domain.dimensions);
  scene.needs = read_needs(root);
  scene.view = read_view(root, scene.domain);
  scene.defaults = read_defaults(root);
  scene.because = read_because(root);
  const auto seed = default_integer(root, "seed", std::numeric_limits<int64_t>::max());
  scene.seed = overrides.seed.value_or(static_cast<uint64_t>(seed.value_or(1)));
  return scene;
}

}  // namespace

Scene parse_scene(std::string_view text, std::string_view file_name, const std::filesystem::path& folder,
                  const SceneOverrides& overrides) {
  const toml::table table = parse_toml(text, file_name);
  const TableReader root = reader_of(table, file_name);
  Scene scene = read_values(root, overrides);
  const SphereLines lines = read_listed_spheres(root, folder, scene);
  override_masses(root, overrides.mass_ratio, scene.bodies);
  const std::vector<Fill> fills = read_counted_fills(root, scene, overrides);
  check_periodic_edges(scene.domain, largest_radius(scene.bodies, fills), root.place("domain"));
  SphereIndex index(scene.domain);
  const int64_t wrapped = check_spheres(scene.domain, scene.physics, lines, scene.bodies, index);
  if (wrapped > 0) {
    scene.notes.push_back(
        fmt::format("{}: {} of {} spheres were outside of the periodic domain, and are at their images inside",
                    lines.file, wrapped, scene.bodies.size()));
  }
  if (scene.bodies.size() == 0 && fills.empty()) {
    scene.notes.push_back(lines.file + ": found no spheres" + (lines.csv ? "" : ", neither [[spheres]] nor [[fill]]"));
  }
  place_fills(scene, fills, index, scene.bodies);
  return scene;
}

Scene read_scene(const std::filesystem::path& path, const SceneOverrides& overrides) {
  return parse_scene(read_file(path), path.string(), path.parent_path(), overrides);
}

SceneInfo parse_scene_info(std::string_view text, std::string_view file_name) {
  const toml::table table = parse_toml(text, file_name);
  return read_info(reader_of(table, file_name));
}

std::span<const SceneInfo> built_in_scenes() {
  static const std::vector<SceneInfo> scenes = [] {
    std::vector<SceneInfo> result;
    for (const EmbeddedFile& file : scene_files()) result.push_back(parse_scene_info(file.text, file.name));
    return result;
  }();
  return scenes;
}

bool is_scene_file(std::string_view name_or_path) {
  return name_or_path.ends_with(".toml") || name_or_path.find('/') != std::string_view::npos;
}

Scene load_scene(std::string_view name_or_path, const SceneOverrides& overrides) {
  if (is_scene_file(name_or_path)) return read_scene(std::filesystem::path(name_or_path), overrides);
  for (const EmbeddedFile& file : scene_files()) {
    if (file.name == std::string(name_or_path) + ".toml") return parse_scene(file.text, file.name, {}, overrides);
  }
  throw UserError("SCENE", in_quotes(name_or_path),
                  join(names_in(built_in_scenes())) + ", or a path that ends in .toml or contains a '/'");
}

}  // namespace ballpit
