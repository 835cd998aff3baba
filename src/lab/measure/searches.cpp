// SPDX-License-Identifier: MIT
#include "lab/measure/searches.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/random.h"
#include "methods/methods.h"
#include "world/world.h"

namespace ballpit {

namespace {

constexpr int kRepeats = 3;            // in a round
constexpr double kLongEnough = 0.002;  // [s] for the clock
constexpr int kMaxSearches = 200;      // in a repeat

/// One method, prepared.
class Runner {
 public:
  Runner(const Settings& settings, const SphereArrays& spheres)
      : search_(cpu_backend().make_pair_search(settings)), spheres_(spheres) {
    const double once = std::min(run(1), run(1));
    times_ = std::clamp(static_cast<int>(kLongEnough / once), 1, kMaxSearches);
  }

  double run_repeat() { return run(times_); }

  SearchReport report() const { return search_->report(); }

 private:
  /// The mean time of a search [s].
  double run(int times) {
    const auto start = std::chrono::steady_clock::now();
    for (int k = 0; k < times; ++k) search_->find(spheres_);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / times;
  }

  std::unique_ptr<PairSearch> search_;
  SphereArrays spheres_;
  int times_ = 1;
};

/// For each method its repeats, candidates and contacts, in one array.
std::vector<double> time_in_turns(const std::vector<Settings>& methods, const SphereSet& spheres) {
  std::vector<Runner> runners;
  for (const Settings& method : methods) runners.emplace_back(method, spheres.arrays());
  std::vector<std::vector<double>> values(methods.size());
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    for (size_t k = 0; k < methods.size(); ++k) values[k].push_back(runners[k].run_repeat());
  }
  std::vector<double> flat;
  for (size_t k = 0; k < methods.size(); ++k) {
    flat.insert(flat.end(), values[k].begin(), values[k].end());
    const SearchReport report = runners[k].report();
    flat.insert(flat.end(), {static_cast<double>(report.candidates), static_cast<double>(report.contacts)});
  }
  return flat;
}

constexpr double kDiameterVolume = std::numbers::pi / 6;  // of the largest sphere

/// [r_max] If 1/r² is uniform, the density of r is ~ r⁻³.
double draw_radius(double ratio, Random& random) { return 1 / std::sqrt(random.uniform(1, ratio * ratio)); }

/// The mean of r³ [r_max³] if 1/r² is uniform from 1 to q²: 2/(q² − 1)·(1 − 1/q).
double mean_cubed_radius(double ratio) { return ratio == 1 ? 1 : 2 / (ratio * (ratio + 1)); }

/// Gaussian with variance 1, as the sum of twelve uniform numbers: the same on every platform.
double gaussian(Random& random) {
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += random.uniform();
  return sum;
}

/// Durstenfeld 1964, Algorithm 235. Neighbours in space are then no neighbours in memory.
void shuffle(std::vector<Vec3>& places, Random& random) {
  for (size_t k = places.size(); k > 1; --k) std::swap(places[k - 1], places[random.bits() % k]);
}

}  // namespace

Vec3d box_of(const UniformSpheres& wanted) {
  const double spheres = static_cast<double>(wanted.count) * kDiameterVolume * mean_cubed_radius(wanted.size_ratio);
  const double width = std::cbrt(spheres / wanted.volume_fraction / wanted.aspect);
  return {width, width, width * wanted.aspect};
}

SphereSet uniform_spheres(const UniformSpheres& wanted, uint64_t seed) {
  Random random(seed);
  const Vec3d box = box_of(wanted);
  SphereSet set;
  for (int64_t i = 0; i < wanted.count; ++i) set.position.push_back(narrow<Vec3>(random.uniform(Vec3d(0.0), box)));
  if (wanted.size_ratio == 1) {
    set.radius = {0.5f};
  } else {
    for (int64_t i = 0; i < wanted.count; ++i) {
      set.radius.push_back(static_cast<float>(0.5 * draw_radius(wanted.size_ratio, random)));
    }
  }
  return set;
}

SphereSet touching_pairs(int64_t count, uint64_t seed) {
  constexpr double kSpacing = 4;        // the width of a pair is at most 2
  constexpr double kDistance = 0.9999;  // [diameters] of the centres, so that rounding keeps the contact
  Random random(seed);
  constexpr double kPlay = kSpacing / 2 - 1.001;
  const auto side = static_cast<int64_t>(std::ceil(std::cbrt(static_cast<double>(count) / 2) - 1e-9));
  SphereSet set;
  for (int64_t k = 0; k < count / 2; ++k) {
    const Vec3d site(static_cast<double>(k % side), static_cast<double>(k / side % side),
                     static_cast<double>(k / (side * side)));
    const Vec3d middle = (site + 0.5) * kSpacing + random.uniform(Vec3d(-kPlay), Vec3d(kPlay));
    const Vec3d half = 0.5 * kDistance * random.direction(3);
    set.position.push_back(narrow<Vec3>(middle - half));
    set.position.push_back(narrow<Vec3>(middle + half));
  }
  shuffle(set.position, random);
  set.radius = {0.5f};
  return set;
}

SphereSet clouds(int64_t count, uint64_t seed) {
  constexpr double kWidth = 3.5, kVolumeFraction = 0.01;
  Random random(seed);
  const Vec3d box(std::cbrt(static_cast<double>(count) * kDiameterVolume / kVolumeFraction));
  std::vector<Vec3d> centers;
  for (int64_t k = 0; k < std::max<int64_t>(1, count / 1000); ++k) centers.push_back(random.uniform(Vec3d(0.0), box));
  SphereSet set;
  for (int64_t i = 0; i < count; ++i) {
    const Vec3d center = centers[random.bits() % centers.size()];
    const double x = gaussian(random), y = gaussian(random), z = gaussian(random);
    set.position.push_back(narrow<Vec3>(center + kWidth * Vec3d(x, y, z)));
  }
  set.radius = {0.5f};
  return set;
}

std::vector<std::vector<SearchTiming>> time_searches(Lab& lab, const std::vector<SearchCase>& cases) {
  std::vector<std::vector<SearchTiming>> timings;
  for (const SearchCase& one : cases) timings.emplace_back(one.methods.size());
  for (int round = 1; round <= kSearchRounds; ++round) {
    for (size_t c = 0; c < cases.size(); ++c) {
      const std::vector<double> flat = lab.time(fmt::format("{}; round {}", cases[c].key, round), [&] {
        return time_in_turns(cases[c].methods, cases[c].make_spheres());
      });
      for (size_t k = 0; k < timings[c].size(); ++k) {
        const auto first = flat.begin() + static_cast<std::ptrdiff_t>(k) * (kRepeats + 2);
        SearchTiming& timing = timings[c][k];
        timing.seconds.insert(timing.seconds.end(), first, first + kRepeats);
        timing.candidates = first[kRepeats];
      }
    }
  }
  return timings;
}

Settings search_by(std::string_view broadphase) {
  Settings settings;
  settings.broadphase = named<BroadPhase>(broadphase);
  settings.threads = 1;
  return settings;
}

const std::vector<std::string>& broad_phases() {
  static const std::vector<std::string> names(
      kNames<BroadPhase>.begin() + 1,  // without auto and the slides' own kernels
      kNames<BroadPhase>.begin() + static_cast<std::ptrdiff_t>(BroadPhase::lecture_brute_force));
  return names;
}

std::string label_of(std::string_view broadphase) {
  std::string label(find_method(named<BroadPhase>(broadphase)).label);
  label[0] = static_cast<char>(label[0] - 'A' + 'a');
  return label;
}

}  // namespace ballpit
