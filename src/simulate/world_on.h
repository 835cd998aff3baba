// SPDX-License-Identifier: MIT
// The world, written once for every executor and number of dimensions. A step, from top to bottom:
//
//     sort       now and then, bodies in memory by where they are
//     detect     broad phase and narrow phase, on frozen positions
//     kick       gravity
//     respond    contacts and walls change velocities
//     drift      positions move
//     check      no sphere has left
//
// Instantiated by backend_cpu.cpp and cuda/backend_cuda.cu.
#pragma once

#include <algorithm>
#include <chrono>
#include <memory>
#include <sstream>

#include "core/error.h"
#include "exec/reduce.h"
#include "simulate/choose_broad_phase.h"
#include "simulate/detector.h"
#include "simulate/integrate/symplectic_euler.h"
#include "simulate/measure.h"
#include "simulate/narrowphase/contact_list.h"
#include "simulate/response/impulse.h"
#include "simulate/spatial_order.h"
#include "simulate/world.h"

namespace ballpit {

template <class V, class Exec>
class WorldOn final : public World {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  WorldOn(std::unique_ptr<Exec> exec, const Scene& scene, const Settings& settings)
      : exec_(std::move(exec)),
        box_{narrow<V>(scene.domain.min), narrow<V>(scene.domain.max), scene.domain.boundary},
        gravity_(narrow<V>(scene.physics.gravity)),
        dt_(settings.dt),
        substeps_(settings.substeps),
        parameters_(parameters_of(scene, settings, box_)),
        choice_(choose_broad_phase(settings, parameters_)),
        detector_(choice_.method, parameters_, skin_of(settings)),
        order_(box_, scene.bodies.size()),
        response_(impulse_parameters(scene.physics, settings)) {
    upload(scene.bodies);
  }

  void step() override {
    const auto start = std::chrono::steady_clock::now();
    if (order_.is_due(steps_)) sort_bodies();
    ++steps_;
    for (int k = 0; k < substeps_; ++k) substep(static_cast<Real>(dt_ / substeps_));
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  Inspection inspect() override {
    detect();
    Inspection result;
    result.bodies.count = position_.size();
    result.bodies.dimensions = kDimensions<V>;
    result.bodies.position = flat(downloaded(position_));
    result.bodies.velocity = flat(downloaded(velocity_));
    const auto radius = downloaded(radius_);
    result.bodies.radius.assign(radius.begin(), radius.end());
    result.contacts = exec_->download(detector_.pairs());
    result.grids = detector_.inspect(*exec_, view());
    const std::vector<int> id_at = exec_->download(order_.id_at());
    if (!id_at.empty()) name_by_id(result, id_at);
    return result;
  }

  Report report() override {
    detect();
    list_.build(*exec_, detector_.pairs(), detector_.first(), view(), box_);
    Report report;
    report.broadphase = choice_.method;
    report.broadphase_reason = choice_.reason;
    report.count = position_.size();
    report.steps = steps_;
    report.time = time();
    report.seconds = seconds_;
    report.contacts = detector_.pairs().size();
    report.candidates = detector_.candidates(*exec_);
    report.searches = detector_.searches();
    report.detection_bytes = detector_.bytes();
    measure_motion(*exec_, view(), gravity_, report);
    report.max_overlap = largest_overlap(*exec_, view(), box_, list_.view());
    report.state_hash = hash_state(downloaded(position_), downloaded(velocity_));
    report.stages = exec_->stage_times().stages();
    return report;
  }

  Bodies bodies() override {
    Bodies result;
    for (const V& p : downloaded(position_)) result.position.push_back(widen(p));
    for (const V& v : downloaded(velocity_)) result.velocity.push_back(widen(v));
    const auto radius = downloaded(radius_), inverse = downloaded(inverse_mass_);
    for (size_t i = 0; i < result.position.size(); ++i) {
      result.radius.push_back(radius[radius.size() == 1 ? 0 : i]);
      result.mass.push_back(1.0 / inverse[inverse.size() == 1 ? 0 : i]);
    }
    return result;
  }

  int64_t steps() const override { return steps_; }
  double time() const override { return static_cast<double>(steps_) * dt_; }

 private:
  static BroadPhaseParameters<V> parameters_of(const Scene& scene, const Settings& settings, const Box<V>& box) {
    const std::vector<Real> radius(scene.bodies.radius.begin(), scene.bodies.radius.end());
    const auto count = static_cast<int64_t>(radius.size());
    return broad_phase_parameters<V>(settings, box, Span<const Real>(radius.data(), count), count);
  }

  static ImpulseParameters impulse_parameters(const Physics& physics, const Settings& settings) {
    const double gravity = length(physics.gravity);
    ImpulseParameters parameters;
    parameters.restitution = physics.restitution;
    parameters.wall_restitution = physics.wall_restitution;
    parameters.push_limit = kPushSteps * gravity * settings.dt / settings.substeps;
    parameters.correction = gravity > 0 ? 0.0 : 0.4;
    return parameters;
  }

  void upload(const Bodies& bodies) {
    std::vector<V> position, velocity;
    for (const Vec3d& p : bodies.position) position.push_back(narrow<V>(p));
    for (const Vec3d& v : bodies.velocity) velocity.push_back(narrow<V>(v));
    exec_->upload(position_, position);
    exec_->upload(velocity_, velocity);
    std::vector<double> inverse_mass;
    for (const double mass : bodies.mass) inverse_mass.push_back(1.0 / mass);
    upload_per_body(radius_, bodies.radius);
    upload_per_body(inverse_mass_, inverse_mass);
  }

  /// One number where all are equal, else one each.
  void upload_per_body(Buffer<Real>& buffer, const std::vector<double>& values) {
    const bool is_uniform = std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
    const auto last = is_uniform && !values.empty() ? values.begin() + 1 : values.end();
    const std::vector<Real> rounded(values.begin(), last);
    exec_->upload(buffer, rounded);
  }

  static PerBody<Real> per_body(const Buffer<Real>& buffer) {
    return {buffer.span().data(), buffer.size() == 1 ? 0 : 1};
  }

  BodiesView<V> view() const {
    return {position_.span(), velocity_.span(), per_body(radius_), per_body(inverse_mass_)};
  }

  /// The values of all bodies by id; one value where all are equal.
  template <class T>
  std::vector<T> downloaded(const Buffer<T>& buffer) const {
    return by_id(exec_->download(buffer.span()), exec_->download(order_.id_at()));
  }

  /// Finds the contacts of the present state, once: looking at them before a step saves the step the work.
  void detect() {
    if (is_detected_) return;
    detector_.find(*exec_, view());
    is_detected_ = true;
  }

  /// Sorts the bodies in memory by where they are.
  void sort_bodies() {
    order_.sort(*exec_, position_.span());
    order_.rearrange(*exec_, position_, after_);
    order_.rearrange(*exec_, velocity_, after_);
    order_.rearrange(*exec_, radius_, scalar_scratch_);
    order_.rearrange(*exec_, inverse_mass_, scalar_scratch_);
    order_.commit(*exec_);
    detector_.discard();
    is_detected_ = false;
  }

  void substep(Real dt) {
    const int64_t n = position_.size();
    detect();
    list_.build(*exec_, detector_.pairs(), detector_.first(), view(), box_);

    after_.resize(n);
    exec_->parallel_for("kick", n, Kick<V>{velocity_.span(), gravity_ * dt, after_.span()});
    response_.respond(*exec_, view(), box_, list_.view(), dt, after_);
    std::swap(velocity_, after_);

    exec_->parallel_for("drift", n, Drift<V>{box_, dt, velocity_.span(), response_.correction(), position_.span()});
    is_detected_ = false;
    check();
  }

  /// Throws where a body is not a number or outside the domain.
  void check() {
    const int64_t bad = first_outside(*exec_, view(), box_, order_.id_at());
    if (bad < 0) return;
    const Vec3d p = widen(downloaded(position_)[static_cast<size_t>(bad)]);
    std::ostringstream message;
    message << "step " << steps_ << " (t = " << time() << " s): sphere " << bad
            << " left the domain: its centre is at (" << p.x << ", " << p.y << ", " << p.z
            << "); a smaller --dt or more --substeps may help";
    throw RunError(message.str());
  }

  static std::vector<float> flat(const std::vector<V>& values) {
    std::vector<float> result;
    result.reserve(values.size() * kDimensions<V>);
    for (const V& value : values) {
      for (int axis = 0; axis < kDimensions<V>; ++axis) result.push_back(static_cast<float>(value[axis]));
    }
    return result;
  }

  // Old overlap is pushed out at most as fast as a body falls in so many steps: enough to carry a heap as many spheres
  // high, and no more, so that freed overlap does not throw spheres up.
  static constexpr double kPushSteps = 100;

  std::unique_ptr<Exec> exec_;
  Box<V> box_;
  V gravity_;  // [m/s²]
  double dt_;  // [s]
  int substeps_;

  Buffer<V> position_, velocity_, after_;
  Buffer<Real> radius_, inverse_mass_, scalar_scratch_;
  BroadPhaseParameters<V> parameters_;
  BroadPhaseChoice choice_;
  Detector<V, Exec> detector_;
  SpatialOrder<V, Exec> order_;
  ContactList<V, Exec> list_;
  ImpulseResponse<V, Exec> response_;

  bool is_detected_ = false;
  int64_t steps_ = 0;
  double seconds_ = 0;
};

/// A world of the scene's dimensions on an executor.
template <class Exec>
std::unique_ptr<World> make_world_on(std::unique_ptr<Exec> exec, const Scene& scene, const Settings& settings) {
  if (scene.domain.dimensions == 2) {
    return std::make_unique<WorldOn<Vec2, Exec>>(std::move(exec), scene, settings);
  }
  return std::make_unique<WorldOn<Vec3, Exec>>(std::move(exec), scene, settings);
}

}  // namespace ballpit
