// SPDX-License-Identifier: MIT
#include "choose/detection.h"

#include <algorithm>
#include <chrono>

#include "choose/candidates.h"
#include "core/error.h"
#include "measure/machine.h"

namespace ballpit {

double time_of_step(const Scene& scene, const Needs& needs, const Settings& settings, double block) {
  using Clock = std::chrono::steady_clock;
  constexpr int kBlocks = 3, kLeastSteps = 4, kMostSteps = 64;
  double least = INFINITY;
  try {
    const auto world = make_pilot_world(scene, needs, settings);
    world->step();
    for (int k = 0; k < kBlocks; ++k) {
      const auto start = Clock::now();
      double seconds = 0;
      int steps = 0;
      while (steps < kLeastSteps || (seconds < block && steps < kMostSteps)) {
        world->step();
        ++steps;
        seconds = std::chrono::duration<double>(Clock::now() - start).count();
      }
      least = std::min(least, seconds / steps);
    }
  } catch (const RunError&) {
    return INFINITY;
  } catch (const UserError&) {
    return INFINITY;
  }
  return least;
}

namespace {

/// Keeps the settings unless others are clearly cheaper.
class Contest {
 public:
  Contest(const Scene& scene, const Needs& needs, const Settings& settings, double block)
      : scene_(scene), needs_(needs), best_(settings), block_(block), least_(time(settings)), first_(least_) {}

  void enter(const Settings& settings) {
    constexpr double kClearly = 0.93;
    const double seconds = time(settings);
    if (seconds < kClearly * least_) best_ = settings, least_ = seconds;
  }

  const Settings& best() const { return best_; }
  double ratio() const { return first_ > 0 && std::isfinite(least_) ? least_ / first_ : 1; }

 private:
  double time(const Settings& settings) const { return time_of_step(scene_, needs_, settings, block_); }

  const Scene& scene_;
  const Needs& needs_;
  Settings best_;
  double block_, least_, first_;
};

/// CUDA if there is a device and it is predicted to be faster: times of a step at two sizes, extrapolated to `count`.
Settings with_cheapest_backend(const Scene& scene, const Needs& needs, Settings settings,
                               const std::vector<GivenOption>& given, int64_t count, double block) {
  const bool runs_on_cuda = settings.response != Response::event_driven;
  if (is_given(given, "backend") || !runs_on_cuda || !cuda_backend().unavailable_reason.empty()) return settings;
  const Scene small = part_of(scene, std::max<int64_t>(1, scene.bodies.size() / 4));
  const auto predict = [&](BackendName backend) {
    settings.backend = backend;
    const double large_time = time_of_step(scene, needs, settings, block);
    const double small_time = time_of_step(small, needs, settings, block);
    const auto difference = static_cast<double>(scene.bodies.size() - small.bodies.size());
    const double slope = difference > 0 ? std::max(0.0, (large_time - small_time) / difference) : 0;
    return large_time + slope * static_cast<double>(count - scene.bodies.size());
  };
  const double on_cpu = predict(BackendName::cpu), on_cuda = predict(BackendName::cuda);
  settings.backend = on_cuda < on_cpu ? BackendName::cuda : BackendName::cpu;
  return settings;
}

}  // namespace

CheapestSearch with_cheapest_search(const Scene& scene, const Needs& needs, const Settings& settings,
                                    const std::vector<GivenOption>& given, int64_t count, double seconds) {
  constexpr int kMeasurements = 12, kBlocks = 3;
  constexpr int64_t kMostForBruteForce = 4000;
  const double block = seconds / kMeasurements / kBlocks;
  Contest contest(scene, needs, settings, block);
  const auto enter = [&](auto member, auto value) {
    Settings other = contest.best();
    other.*member = value;
    contest.enter(other);
  };
  if (!is_given(given, "broadphase")) {
    for (const BroadPhase method :
         {BroadPhase::sorted_grid, BroadPhase::linked_cell, BroadPhase::sort_and_sweep, BroadPhase::brute_force}) {
      if (method == BroadPhase::brute_force && count > kMostForBruteForce) continue;
      Settings other = contest.best();
      other.skin = skin_of(settings);
      other.broadphase = method;
      contest.enter(other);
    }
  }
  if (!is_given(given, "skin")) {
    for (const double skin : {0.0, 0.03, 0.2, 0.5}) enter(&Settings::skin, skin);
  }
  if (!is_given(given, "threads") && thread_count(0) > 1) {
    if (count > scene.bodies.size()) {
      Settings all = contest.best();  // more spheres than are piloted are worth all threads
      all.threads = 0;
      return {with_cheapest_backend(scene, needs, all, given, count, block), contest.ratio()};
    }
    enter(&Settings::threads, contest.best().threads == 1 ? 0 : 1);
  }
  return {with_cheapest_backend(scene, needs, contest.best(), given, count, block), contest.ratio()};
}

int cheapest_threads(const Scene& scene, const Needs& needs, const Settings& settings,
                     const std::vector<GivenOption>& given) {
  constexpr int64_t kFew = 64;
  constexpr double kBlock = 0.004;  // [s]
  if (is_given(given, "threads") || settings.response == Response::event_driven) return settings.threads;
  if (thread_count(0) == 1 || scene.bodies.size() <= kFew) return 1;
  Settings one = settings;
  one.threads = 1;
  Contest contest(scene, needs, one, kBlock);
  one.threads = 0;
  contest.enter(one);
  return contest.best().threads;
}

}  // namespace ballpit
