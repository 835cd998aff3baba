// SPDX-License-Identifier: MIT
// The world, written once for every executor, number of dimensions and precision. A step, from top to bottom:
//
//     sort       now and then, bodies in memory by where they are
//     substeps   detect, respond, integrate: substepper.h
//     guard      no sphere has left; now and then: nothing overlaps too much, no energy came from nowhere
//
// Instantiated for each vector type by worlds_cpu.cpp and cuda/worlds_cuda_*.cu.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "bodies/body_snapshot.h"
#include "methods/methods.h"
#include "world/guard.h"
#include "world/inspect_more.h"
#include "world/inspection.h"
#include "world/make_world.h"
#include "world/snapshot.h"
#include "world/substepper.h"
#include "world/sums.h"
#include "world/world.h"
#include "world/write_bodies.h"

namespace ballpit {

template <class V, class Exec>
class WorldOn final : public World {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  WorldOn(std::unique_ptr<Exec> exec, const Scene& scene, const Settings& settings)
      : dt_(settings.dt),
        substeps_(settings.substeps),
        state_(std::move(exec), scene, settings, margin_of(scene, settings)),
        substepper_(make_substepper<V, Exec>(scene, settings)),
        tally_(settings.keeps_tally),
        guard_(settings.max_overlap, settings.max_energy, settings.dt / settings.substeps, hint_of(scene, settings)) {}

  void step() override {
    const auto start = std::chrono::steady_clock::now();
    if (!guard_.is_started()) guard_.start(state_, substepper_->elastic_energy(state_));
    if (state_.order().is_due(steps_)) sort();
    ++steps_;
    const Real h = static_cast<Real>(dt_ / substeps_);
    for (int k = 0; k < substeps_; ++k) substepper_->substep(state_, tally_, h);
    guard_.check_inside(state_, steps_, time());
    if (guard_.is_due(steps_)) guard_.check(state_, steps_, time());
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  Inspection inspect(const Wanted& wanted) override {
    Exec& exec = state_.exec();
    Inspection result;
    result.bodies.count = state_.count();
    result.bodies.dimensions = kDimensions<V>;
    if (!wanted.state) return result;
    result.bodies.position = flat(state_.downloaded(state_.position));
    result.bodies.velocity = flat(state_.downloaded(state_.velocity));
    const std::vector<Real> radius = state_.radii();
    result.bodies.radius.assign(radius.begin(), radius.end());
    result.contacts = exec.download(state_.pairs());
    result.grids = state_.detector().inspect(exec, state_.bodies());
    if (wanted.more_than_state()) inspect_more(state_, wanted, result);
    const std::vector<int> id_at = exec.download(state_.order().id_at());
    if (!id_at.empty()) name_by_id(result, id_at);
    return result;
  }

  Report report() override {
    Exec& exec = state_.exec();
    Report report;
    report.contacts = state_.pairs().size();
    report.broadphase = name_of(state_.choice().method);
    report.broadphase_reason = state_.choice().reason;
    report.count = state_.count();
    report.steps = steps_;
    report.time = time();
    report.seconds = seconds_;
    report.candidates = state_.detector().candidates(exec);
    report.searches = state_.detector().searches();
    report.detection_bytes = state_.detector().bytes();
    report.body_bytes = state_.bytes();
    report.motion_bytes = substepper_->bytes() + guard_.bytes() + tally_.bytes();
    measure_motion(exec, state_.bodies(), state_.gravity(), report);
    report.elastic_energy = substepper_->elastic_energy(state_);
    report.max_overlap = largest_overlap(exec, state_.bodies(), state_.box(), state_.pairs());
    report.state_hash = reduce(exec, "hash state", state_.count(), uint64_t(0),
                               HashOfBody<V>{state_.bodies(), state_.order().id_at()}, Sum{});
    report.tally = tally_.tally();
    report.stages = exec.stage_times().stages();
    return report;
  }

  bool detect_by(const Settings& settings) override {
    state_.detect_by(settings);
    state_.exec().stage_times().clear();
    return true;
  }

  BodyShape shape() const override { return state_.shape(); }
  void write_bodies(const BodyTarget& target) override { ballpit::write_bodies(state_, target); }

  Bodies bodies() override { return state_.download(state_.position, state_.velocity); }
  Bodies last_good() override { return guard_.is_started() ? guard_.last_good(state_) : bodies(); }
  double last_good_time() override { return guard_.last_good_time(); }

  std::unique_ptr<Snapshot> snapshot() override {
    auto result = std::make_unique<PartsSnapshot>();
    for_each_saved(SavePart<Exec>{state_.exec(), *result});
    return result;
  }

  void restore(const Snapshot& snapshot) override {
    size_t next = 0;
    for_each_saved(RestorePart<Exec>{state_.exec(), dynamic_cast<const PartsSnapshot&>(snapshot), next});
    state_.restored();
  }

  int64_t steps() const override { return steps_; }
  double time() const override { return static_cast<double>(steps_) * dt_; }

 private:
  /// [m] that spheres may be apart and be contacts for the position-based response: part of a radius, and what gravity does.
  static double margin_of(const Scene& scene, const Settings& settings) {
    if (settings.response != Response::position_based || scene.bodies.size() == 0) return 0;
    const double h = settings.dt / settings.substeps;
    const auto& radius = scene.bodies.radius;
    return 0.01 * *std::max_element(radius.begin(), radius.end()) + length(scene.physics.gravity) * h * h;
  }

  /// What helps against overlap: where springs are resolved by the steps, only stiffer ones do.
  static std::string hint_of(const Scene& scene, const Settings& settings) {
    if (settings.response != Response::penalty || scene.bodies.size() == 0) return kSmallerSteps;
    const double radius = *std::min_element(scene.bodies.radius.begin(), scene.bodies.radius.end());
    const double mass = *std::min_element(scene.bodies.mass.begin(), scene.bodies.mass.end());
    // Hertz's springs grow stiffer with overlap: at the largest that is allowed.
    const double stiffness =
        scene.physics.stiffness *
        (scene.physics.law == "hertz" ? 1.5 * std::sqrt(std::fmin(settings.max_overlap, 1.0) * radius) : 1.0);
    const bool is_resolved = settings.dt / settings.substeps < kResolved * std::sqrt(mass / stiffness);
    if (is_resolved && integrator_of(settings) != Integrator::explicit_euler) {
      return "a larger [physics] stiffness may help (and the smaller --dt that it needs)";
    }
    return kSmallerSteps;
  }

  void sort() {
    state_.sort([&](const auto& rearrange) {
      for (Buffer<V>* const values : substepper_->kept()) rearrange(*values);
      tally_.for_each_kept(rearrange);
      guard_.for_each_kept(rearrange);
    });
  }

  /// Calls visit(part) for each part of a snapshot.
  template <class Visit>
  void for_each_saved(const Visit& visit) {
    visit(steps_);
    state_.for_each_saved(visit);
    for (Buffer<V>* const values : substepper_->kept()) visit(*values);
    for (int64_t* const number : substepper_->counters()) visit(*number);
    tally_.for_each_saved(visit);
    guard_.for_each_saved(state_, time(), visit);
  }

  static std::vector<float> flat(const std::vector<V>& values) {
    std::vector<float> result;
    result.reserve(values.size() * kDimensions<V>);
    for (const V& value : values) {
      for (int axis = 0; axis < kDimensions<V>; ++axis) result.push_back(static_cast<float>(value[axis]));
    }
    return result;
  }

  static constexpr const char* kSmallerSteps = "a smaller --dt or more --substeps may help";
  static constexpr double kResolved = 0.5;  // of √(m/k): well below the 0.71 at which packings become unstable

  double dt_;  // [s]
  int substeps_;
  StepState<V, Exec> state_;
  std::unique_ptr<Substepper<V, Exec>> substepper_;
  TallyKeeper<V, Exec> tally_;
  Guard<V, Exec> guard_;
  int64_t steps_ = 0;
  double seconds_ = 0;
};

template <class V, class Exec>
std::unique_ptr<World> make_world_of(std::unique_ptr<Exec> exec, const Scene& scene, const Settings& settings) {
  return std::make_unique<WorldOn<V, Exec>>(std::move(exec), scene, settings);
}

}  // namespace ballpit
