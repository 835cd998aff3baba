// SPDX-License-Identifier: MIT
#include "measure/step_timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <new>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "core/random.h"
#include "measure/statistics.h"

namespace ballpit {

namespace {

constexpr double kRadius = 0.01;  // [m]
constexpr double kMass = 0.004;   // [kg]

/// Sites of a cubic lattice with `side` sites along each edge, displaced at random.
std::vector<Vec3d> jittered_lattice(int64_t count, int64_t side, double spacing, Random& random) {
  const double jitter = spacing / 2 - kRadius;
  std::vector<Vec3d> places;
  places.reserve(static_cast<size_t>(count));
  for (int64_t k = 0; k < count; ++k) {
    const Vec3d cell(static_cast<double>(k % side), static_cast<double>(k / side % side),
                     static_cast<double>(k / (side * side)));
    places.push_back((cell + 0.5) * spacing + random.uniform(Vec3d(-jitter), Vec3d(jitter)));
  }
  return places;
}

/// Durstenfeld 1964, Algorithm 235.
void shuffle(std::vector<Vec3d>& places, Random& random) {
  for (size_t k = places.size(); k > 1; --k) {
    std::swap(places[k - 1], places[static_cast<size_t>(random.uniform() * static_cast<double>(k))]);
  }
}

constexpr double kBlockSeconds = 0.05;  // long enough for the clock and for short interruptions
constexpr int kMaxSteps = 200;          // in a block

/// The time of a step with this number of spheres.
struct Cost {
  int64_t count;
  double seconds;
};

/// Predicts the time of a step by the power law through the two largest known costs. The time of every method grows
/// with an exponent between 1 and 2.
double predict(const std::vector<Cost>& known, int64_t count) {
  const Cost& a = known[known.size() - 2];
  const Cost& b = known.back();
  const double ratio = static_cast<double>(b.count) / static_cast<double>(a.count);
  const double exponent = std::clamp(std::log(b.seconds / a.seconds) / std::log(ratio), 1.0, 2.0);
  return b.seconds * std::pow(static_cast<double>(count) / static_cast<double>(b.count), exponent);
}

/// Time of each stage between two reports of a world.
std::vector<Stage> between(const std::vector<Stage>& before, const std::vector<Stage>& after) {
  std::vector<Stage> result = after;
  for (Stage& stage : result) {
    for (const Stage& earlier : before) {
      if (earlier.name != stage.name) continue;
      stage.seconds -= earlier.seconds;
      stage.launches -= earlier.launches;
    }
  }
  return result;
}

/// A world whose steps are timed. A report launches stages of its own. Two reports in a row show which, so that they
/// can be subtracted.
class TimedWorld {
 public:
  TimedWorld(const Scene& gas, const Settings& settings, const StepCase& which) {
    Settings own = settings;
    own.broadphase = named<BroadPhase>(which.method);
    own.threads = which.threads;
    own.dt = kGasStep;
    world_ = which.backend.make_world(gas, own);
    world_->step();  // the first one allocates most of its memory
    start_ = world_->report().stages;
    reported_ = world_->report().stages;
    run(1);  // its contacts were detected for the report
  }

  /// The mean time of a step [s].
  double run(int steps) {
    const auto start = std::chrono::steady_clock::now();
    for (int k = 0; k < steps; ++k) world_->step();
    world_->wait();
    steps_ += steps;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / steps;
  }

  /// Contacts, candidates, and the stages of a step.
  void describe(StepTiming& timing) {
    Report report = world_->report();
    timing.contacts = report.contacts;
    timing.candidates = report.candidates;
    if (reported_.empty()) report.stages = time_stages();
    for (Stage& stage : between(between(start_, reported_), between(reported_, report.stages))) {
      if (stage.launches <= 0) continue;
      timing.stages.push_back(
          {stage.name, std::max(0.0, stage.seconds) / steps_, static_cast<double>(stage.launches) / steps_});
    }
  }

 private:
  /// Of a world that times its stages only while somebody asks, since that costs time.
  std::vector<Stage> time_stages() {
    constexpr int kStageSteps = 32;
    world_->time_stages(true);
    start_ = world_->report().stages;
    reported_ = world_->report().stages;
    steps_ = 0;
    run(kStageSteps);
    return world_->report().stages;
  }

  std::unique_ptr<World> world_;
  std::vector<Stage> start_, reported_;
  int steps_ = 0;
};

/// Runs `work`, whose failure must not end the other cases. Returns the reason of a failure.
template <class Work>
std::string failure_of(const Work& work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Times one case for all counts.
class CaseTimer {
 public:
  CaseTimer(const StepCase& which, const TimingPlan& plan) : which_(which), plan_(plan) {}

  /// Whether this number of spheres is likely to stay within the limit; if not, the timing gives the reason.
  bool expects(int64_t count) {
    timing_ = {which_, count, {}, {}, 0, 0, 0, {}};
    timing_.skipped = failure_of([&] {
      if (known_.size() < 2 && count > kProbes[1]) known_ = {probe(kProbes[0]), probe(kProbes[1])};
      if (known_.size() >= 2) check(predict(known_, count), "a step would take about ");
    });
    return timing_.skipped.empty();
  }

  void start(const Scene& gas) {
    timing_.skipped = failure_of([&] {
      world_ = std::make_unique<TimedWorld>(gas, plan_.settings, which_);
      const double step = std::min(world_->run(1), world_->run(1));
      known_.push_back({timing_.count, step});
      check(step, "a step takes ");
      timing_.steps = std::clamp(static_cast<int>(kBlockSeconds / step), 1, kMaxSteps);
    });
    if (!timing_.skipped.empty()) world_.reset();
  }

  bool is_running() const { return world_ != nullptr; }

  void run_block() {
    timing_.skipped = failure_of([&] { timing_.seconds.push_back(world_->run(timing_.steps)); });
    if (!timing_.skipped.empty()) world_.reset();
  }

  StepTiming take() {
    if (world_) {
      world_->describe(timing_);
      known_.back().seconds = spread_of(timing_.seconds).median;
    }
    world_.reset();
    return std::move(timing_);
  }

 private:
  static constexpr int64_t kProbes[] = {1000, 10000};  // numbers of spheres that no method needs long for

  Cost probe(int64_t count) const {
    TimedWorld world(make_gas(count, plan_.seed), plan_.settings, which_);
    return {count, world.run(1)};
  }

  /// Throws if the blocks would exceed the limit.
  void check(double step, const char* words) const {
    if (step * plan_.blocks <= plan_.limit) return;
    throw std::runtime_error(fmt::format("{}{:.3g} s, {} blocks at least {:.3g} s; --limit is {:.3g} s", words, step,
                                         plan_.blocks, step * plan_.blocks, plan_.limit));
  }

  StepCase which_;
  const TimingPlan& plan_;
  std::vector<Cost> known_;
  StepTiming timing_;
  std::unique_ptr<TimedWorld> world_;
};

/// The gas after its first steps. The lattice that it starts from has no contacts.
Scene gas_in_motion(int64_t count, uint64_t seed) {
  Scene gas = make_gas(count, seed);
  Settings settings;
  settings.dt = kGasStep;
  const std::unique_ptr<World> world = cpu_backend().make_world(gas, settings);
  for (int k = 0; k < kGasStepsToEquilibrium; ++k) world->step();
  gas.bodies = world->bodies();
  return gas;
}

void time_count(std::vector<CaseTimer>& timers, const TimingPlan& plan, int64_t count,
                const std::function<bool()>& stop) {
  std::vector<CaseTimer*> running;
  for (CaseTimer& timer : timers) {
    if (!stop() && timer.expects(count)) running.push_back(&timer);
  }
  if (running.empty()) return;
  const Scene gas = gas_in_motion(count, plan.seed);
  for (CaseTimer* timer : running) timer->start(gas);
  for (int block = 0; block < plan.blocks && !stop(); ++block) {
    for (CaseTimer* timer : running) {
      if (timer->is_running()) timer->run_block();
    }
  }
}

}  // namespace

Scene make_gas(int64_t count, uint64_t seed) {
  Random random(seed);
  const double spacing = kRadius * std::cbrt(4.0 / 3 * std::numbers::pi / kGasVolumeFraction);
  const auto side = static_cast<int64_t>(std::ceil(std::cbrt(static_cast<double>(count)) - 1e-9));
  Scene scene;
  scene.name = "gas";
  scene.domain.max = Vec3d(static_cast<double>(side) * spacing);
  scene.physics.restitution = scene.physics.wall_restitution = 1.0;
  scene.bodies.position = jittered_lattice(count, side, spacing, random);
  shuffle(scene.bodies.position, random);
  for (int64_t k = 0; k < count; ++k) scene.bodies.velocity.push_back(random.uniform() * random.direction(3));
  scene.bodies.radius.assign(static_cast<size_t>(count), kRadius);
  scene.bodies.mass.assign(static_cast<size_t>(count), kMass);
  return scene;
}

std::vector<StepTiming> time_steps(const TimingPlan& plan, const std::function<void(int64_t)>& tell,
                                   const std::function<bool()>& stop) {
  std::vector<CaseTimer> timers;
  for (const StepCase& which : plan.cases) timers.emplace_back(which, plan);
  std::vector<StepTiming> timings;
  for (const int64_t count : plan.counts) {
    time_count(timers, plan, count, stop);
    if (stop()) break;
    for (CaseTimer& timer : timers) timings.push_back(timer.take());
    tell(static_cast<int64_t>(timings.size()));
  }
  return timings;
}

}  // namespace ballpit
