// SPDX-License-Identifier: MIT
#include "scene/read_scene.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/file.h"
#include "scene/read_sections.h"
#include "scene/spheres_csv.h"

namespace ballpit {

namespace {

constexpr std::string_view kTopLevelKeys[] = {"title",   "description", "title_de", "description_de", "domain",
                                              "physics", "spheres",     "fill",     "defaults",       "needs"};

std::string stem_of(std::string_view file_name) { return std::filesystem::path(file_name).stem().string(); }

SceneInfo read_info(const TableReader& reader, std::string_view file_name) {
  SceneInfo info;
  info.name = stem_of(file_name);
  info.title = reader.text("title").value_or(info.name);
  info.description = reader.text("description").value_or("");
  info.title_de = reader.text("title_de").value_or(info.title);
  info.description_de = reader.text("description_de").value_or(info.description);
  return info;
}

/// `spheres = "file.csv"` or tables [[spheres]].
SphereLines read_listed_spheres(const TableReader& reader, const std::string& file, const std::filesystem::path& folder,
                                Scene& scene) {
  SphereLines lines{file, {}};
  const toml::node* node = reader.table().get("spheres");
  if (node != nullptr && node->is_string()) {
    const std::filesystem::path path = folder / node->as_string()->get();
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
      throw reader.error("spheres", describe(*node) + ", but no such file", "a CSV file beside the scene");
    }
    SphereSource source;
    scene.bodies = read_spheres_csv(path, scene.physics.density, &source);
    lines.file = path.string();
    lines.csv = true;
    lines.line = std::move(source.line);
    if (!source.note.empty()) scene.notes.push_back(std::move(source.note));
  } else if (node != nullptr && !node->is_array()) {
    throw reader.error("spheres", describe(*node), "tables [[spheres]], or the name of a CSV file");
  } else {
    for (const toml::table* table : reader.tables("spheres")) {
      read_sphere(*table, scene.domain, scene.physics, lines, scene.bodies);
    }
  }
  return lines;
}

/// An integer of [defaults], which the reader of the scene needs before the option table sees it.
std::optional<int64_t> default_integer(const toml::table* defaults, const std::string& file, std::string_view key,
                                       int64_t high) {
  if (defaults == nullptr || !defaults->contains(key)) return std::nullopt;
  const toml::node& node = *defaults->get(key);
  const std::optional<int64_t> value = whole_number(node);
  if (value && *value >= 0 && *value <= high) return value;
  throw input_error({file, std::max(1, static_cast<int>(node.source().begin.line))}, "[defaults] " + std::string(key),
                    describe(node), "an integer, 0 to " + std::to_string(high));
}

/// Shares `total` out in proportion to the counts; what rounding leaves goes to the first fills.
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

/// `key` is "--count" or "[defaults] count", which errors about the fills then name too.
void override_count(std::vector<Fill>& fills, int64_t count, const Place& place, const std::string& key) {
  if (count < 0 || count > kLargestCount) {
    throw input_error(place, key, std::to_string(count), "0 to " + std::to_string(kLargestCount));
  }
  if (fills.empty()) throw input_error(place, key, std::to_string(count), "only in a scene with a [[fill]]");
  scale_counts(fills, count);
  for (Fill& fill : fills) fill.count_key = "[[fill]] count (" + key + ")";
}

std::vector<Fill> read_fills(const TableReader& reader, const std::string& file, const Scene& scene,
                             const SceneOverrides& overrides) {
  std::vector<Fill> fills;
  for (const toml::table* table : reader.tables("fill")) {
    fills.push_back(read_fill(*table, file, scene.domain, scene.physics));
  }
  const toml::table* defaults = reader.subtable("defaults");
  if (overrides.count) {
    override_count(fills, *overrides.count, reader.place("fill"), "--count");
  } else if (const auto count = default_integer(defaults, file, "count", kLargestCount)) {
    override_count(fills, *count, reader.place("defaults"), "[defaults] count");
  }
  int64_t total = scene.bodies.size();
  for (const Fill& fill : fills) {
    total += fill.count;
    if (total <= kLargestCount) continue;
    throw input_error(fill.place, fill.count_key, std::to_string(total) + " spheres altogether",
                      "at most " + std::to_string(kLargestCount));
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

/// The values of the file, before any sphere.
Scene read_values(const TableReader& reader, const std::string& file, const SceneOverrides& overrides) {
  SceneInfo info = read_info(reader, file);
  Scene scene{info.name, info.title, info.description, info.title_de, info.description_de, {}, {}, {}, {}, {}};
  if (const auto* table = reader.subtable("domain")) {
    scene.domain = read_domain(*table, file);
  } else {
    scene.notes.push_back(file + ": found no [domain]: it is a cube of 1 m with walls, from 0 to 1 along each axis");
  }
  if (const auto* table = reader.subtable("physics")) {
    scene.physics = read_physics(*table, file, scene.domain.dimensions);
  }
  if (const auto* table = reader.subtable("needs")) scene.needs = read_needs(*table, file);
  const toml::table* defaults = reader.subtable("defaults");
  if (defaults != nullptr) scene.defaults = read_defaults(*defaults, file);
  const auto seed = default_integer(defaults, file, "seed", std::numeric_limits<int64_t>::max());
  scene.seed = overrides.seed.value_or(static_cast<uint64_t>(seed.value_or(1)));
  return scene;
}

}  // namespace

Scene parse_scene(std::string_view text, std::string_view file_name, const std::filesystem::path& folder,
                  const SceneOverrides& overrides) {
  const std::string file(file_name);
  const toml::table root = parse_toml(text, file_name);
  const TableReader reader(root, file, "", kTopLevelKeys);
  Scene scene = read_values(reader, file, overrides);
  const SphereLines lines = read_listed_spheres(reader, file, folder, scene);
  const std::vector<Fill> fills = read_fills(reader, file, scene, overrides);
  check_periodic_edges(scene.domain, largest_radius(scene.bodies, fills), reader.place("domain"));
  SphereIndex index(scene.domain);
  const int64_t wrapped = check_spheres(scene.domain, scene.physics, lines, scene.bodies, index);
  if (wrapped > 0) {
    scene.notes.push_back(lines.file + ": " + std::to_string(wrapped) + " of " + std::to_string(scene.bodies.size()) +
                          " spheres were outside of the periodic domain, and are at their images inside");
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
  const toml::table root = parse_toml(text, file_name);
  return read_info(TableReader(root, std::string(file_name), "", kTopLevelKeys), file_name);
}

}  // namespace ballpit
