// SPDX-License-Identifier: MIT
#include "lab/measure/search_timing.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

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

}  // namespace

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
  static const std::vector<std::string> names(kNames<BroadPhase>.begin() + 1,
                                              kNames<BroadPhase>.end());  // without auto
  return names;
}

std::string label_of(std::string_view broadphase) {
  std::string label(find_method(named<BroadPhase>(broadphase)).label);
  label[0] = static_cast<char>(label[0] - 'A' + 'a');
  return label;
}

}  // namespace ballpit
