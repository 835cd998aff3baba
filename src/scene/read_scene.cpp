// SPDX-License-Identifier: MIT
#include "scene/read_scene.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/file.h"
#include "scene/read_sections.h"
#include "scene/spheres_csv.h"
#include "scene_files.h"

namespace ballpit {

namespace {

TableReader reader_of(const toml::table& root, std::string_view file_name) {
  return {root,
          std::string(file_name),
          "",
          {"title", "description", "title_de", "description_de", "domain", "physics", "spheres", "fill", "defaults",
           "needs"}};
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
  SphereSource source;
  scene.bodies = read_spheres_csv(path, scene.physics.density, &source);
  if (!source.note.empty()) scene.notes.push_back(std::move(source.note));
  return {path.string(), std::move(source.line), true};
}

/// An integer of [defaults] that the reader of the scene needs itself.
std::optional<int64_t> default_integer(const TableReader& root, std::string_view key, int64_t high) {
  const auto defaults = root.section("defaults", {});
  return defaults ? defaults->integer(key, 0, high) : std::nullopt;
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
  scene.defaults = read_defaults(root);
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
  throw UserError("SCENE", quoted(name_or_path),
                  join(names_in(built_in_scenes())) + ", or a path that ends in .toml or contains a '/'");
}

}  // namespace ballpit
