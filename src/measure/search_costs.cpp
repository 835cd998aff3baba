// SPDX-License-Identifier: MIT
#include "measure/search_costs.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file.h"
#include "measure/machine.h"
#include "measure/statistics.h"
#include "measure/step_timing.h"

namespace ballpit {

namespace {

using Json = nlohmann::ordered_json;

struct Part {
  std::string_view name;
  double SearchCosts::*cost;
};
constexpr std::array kParts{Part{"vector_test", &SearchCosts::vector_test},
                            Part{"sweep_test", &SearchCosts::sweep_test},
                            Part{"short_test", &SearchCosts::short_test},
                            Part{"list_test", &SearchCosts::list_test},
                            Part{"sort", &SearchCosts::sort},
                            Part{"bin", &SearchCosts::bin},
                            Part{"link", &SearchCosts::link},
                            Part{"each", &SearchCosts::each}};

/// The gas of `ballpit bench` at rest, in a box that is `stretch` times as long along each axis.
Scene gas_at_rest(int64_t count, double stretch) {
  Scene scene = make_gas(count);
  scene.domain.max *= stretch;
  for (Vec3d& p : scene.bodies.position) p *= stretch;
  std::ranges::fill(scene.bodies.velocity, Vec3d(0.0));
  return scene;
}

/// [ns] of a step for each sphere: the median of five blocks.
double nanoseconds(const Backend& backend, const Scene& scene, BroadPhase method, Precision precision) {
  constexpr int kBlocks = 5, kSteps = 2;
  Settings settings;
  settings.broadphase = method;
  settings.precision = precision;
  settings.threads = 1;
  settings.response = Response::kinematic;
  const auto world = backend.make_world(scene, settings);
  world->step();
  std::vector<double> blocks;
  for (int block = 0; block < kBlocks; ++block) {
    const auto start = std::chrono::steady_clock::now();
    for (int k = 0; k < kSteps; ++k) world->step();
    blocks.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  return spread_of(blocks).median / kSteps / double(scene.bodies.size());
}

/// The expected number of centres in a block of cells around a sphere.
double in_block(const Scene& scene) {
  const double edge = 2 * scene.bodies.radius[0];
  double part = 1;
  for (int axis = 0; axis < 3; ++axis) {
    part *= std::min(1.0, 3 * edge / (scene.domain.max[axis] - scene.domain.min[axis]));
  }
  return part * double(scene.bodies.size());
}

/// The expected tests of sort and sweep for each sphere, as --broadphase auto expects them.
double swept(const Scene& scene) {
  const double edge = scene.domain.max.x - scene.domain.min.x;
  return double(scene.bodies.size()) * 1.5 * scene.bodies.radius[0] / edge;
}

/// Sets t = base + slope·x from two measured points, x1 < x2. At least a fifth of t1 counts as base, whatever noise
/// makes of it.
void fit(double x1, double t1, double x2, double t2, double& base, double& slope) {
  base = std::max(0.2 * t1, t1 - (t2 - t1) / (x2 - x1) * x1);
  slope = std::max(1e-3, (t2 - base) / x2);
}

std::filesystem::path cache_file() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if (cache != nullptr && *cache != 0) return std::filesystem::path(cache) / "ballpit" / "costs.json";
  return home != nullptr && *home != 0 ? std::filesystem::path(home) / ".cache" / "ballpit" / "costs.json" : "";
}

Json read_cache(const std::filesystem::path& path) {
  try {
    std::error_code ignored;
    if (!path.empty() && std::filesystem::exists(path, ignored)) {
      Json kept = Json::parse(read_file(path));
      if (kept.is_object()) return kept;
    }
  } catch (const std::exception&) {
    // counts as empty
  }
  return Json::object();
}

std::optional<SearchCosts> costs_in(const Json& kept, const std::string& key) {
  const auto entry = kept.find(key);
  if (entry == kept.end() || !entry->is_object()) return std::nullopt;
  SearchCosts costs;
  for (const Part& part : kParts) {
    const auto value = entry->find(part.name);
    if (value == entry->end() || !value->is_number() || !(value->get<double>() > 0)) return std::nullopt;
    costs.*part.cost = value->get<double>();
  }
  return costs;
}

void keep(const std::filesystem::path& path, const std::string& key, const SearchCosts& costs) {
  if (path.empty()) return;
  Json kept = read_cache(path), entry;
  for (const Part& part : kParts) entry[std::string(part.name)] = costs.*part.cost;
  kept[key] = entry;
  try {
    make_folder(path.parent_path());
    write_file(path, kept.dump(2) + "\n");
  } catch (const RunError&) {
    // measured again next time
  }
}

}  // namespace

SearchCosts measure_search_costs(const Backend& backend, Precision precision) {
  constexpr int64_t kFew = 1000, kMany = 3000;
  constexpr double kThin = 2;  // an eighth of the density
  const Scene few = gas_at_rest(kFew, 1), many = gas_at_rest(kMany, 1), thin = gas_at_rest(kMany, kThin);
  const auto time = [&](const Scene& scene, BroadPhase method) {
    return nanoseconds(backend, scene, method, precision);
  };
  SearchCosts costs;
  fit(kFew / 2.0, time(few, BroadPhase::brute_force), kMany / 2.0, time(many, BroadPhase::brute_force), costs.each,
      costs.vector_test);
  fit(in_block(thin), time(thin, BroadPhase::linked_cell), in_block(many), time(many, BroadPhase::linked_cell),
      costs.link, costs.list_test);
  fit(in_block(thin) / 2, time(thin, BroadPhase::sorted_grid), in_block(many) / 2, time(many, BroadPhase::sorted_grid),
      costs.bin, costs.short_test);
  fit(swept(thin), time(thin, BroadPhase::sort_and_sweep), swept(many), time(many, BroadPhase::sort_and_sweep),
      costs.sort, costs.sweep_test);
  // Brute force prepares nothing, so a sphere costs it less than it costs the others.
  costs.each = std::min({costs.each, costs.sort / 2, costs.bin / 2, costs.link / 2});
  return costs;
}

SearchCosts search_costs(const Backend& backend, Precision precision, bool remeasure) {
  const std::filesystem::path path = cache_file();
  const std::string key = fmt::format("{}; {}; {}", machine_line(), backend.name, name_of(precision));
  if (!remeasure) {
    if (const std::optional<SearchCosts> kept = costs_in(read_cache(path), key)) return *kept;
  }
  const SearchCosts costs = measure_search_costs(backend, precision);
  keep(path, key, costs);
  return costs;
}

}  // namespace ballpit
