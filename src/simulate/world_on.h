// SPDX-License-Identifier: MIT
// The world, written once for every executor and number of dimensions. A step, from top to bottom:
//
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
#include <variant>

#include "core/error.h"
#include "exec/reduce.h"
#include "simulate/broadphase/brute_force.h"
#include "simulate/broadphase/linked_cell.h"
#include "simulate/integrate/symplectic_euler.h"
#include "simulate/measure.h"
#include "simulate/narrowphase/contact_list.h"
#include "simulate/narrowphase/find_contacts.h"
#include "simulate/response/impulse.h"
#include "simulate/world.h"

namespace ballpit {

template <class V, class Exec>
class WorldOn final : public World {
  using Real = Scalar<V>;
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;
  using BroadPhase = std::variant<BruteForce<V, Exec>, LinkedCell<V, Exec>>;

 public:
  WorldOn(std::unique_ptr<Exec> exec, const Scene& scene, const Settings& settings)
      : exec_(std::move(exec)),
        box_{narrow<V>(scene.domain.min), narrow<V>(scene.domain.max), scene.domain.boundary},
        gravity_(narrow<V>(scene.physics.gravity)),
        dt_(settings.dt),
        substeps_(settings.substeps),
        broad_phase_(make_broad_phase(scene, settings)),
        response_(impulse_parameters(scene.physics, settings)) {
    upload(scene.bodies);
  }

  void step() override {
    const auto start = std::chrono::steady_clock::now();
    ++steps_;
    for (int k = 0; k < substeps_; ++k) substep(static_cast<Real>(dt_ / substeps_));
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  Inspection inspect() override {
    detect();
    Inspection result;
    result.bodies.count = position_.size();
    result.bodies.dimensions = kDimensions<V>;
    result.bodies.position = flat(exec_->download(position_.span()));
    result.bodies.velocity = flat(exec_->download(velocity_.span()));
    const auto radius = exec_->download(radius_.span());
    result.bodies.radius.assign(radius.begin(), radius.end());
    result.contacts = exec_->download(contacts_.pairs());
    result.grid = std::visit([&](auto& method) { return method.inspect(*exec_); }, broad_phase_);
    return result;
  }

  Report report() override {
    detect();
    list_.build(*exec_, contacts_, view(), box_);
    Report report;
    report.count = position_.size();
    report.steps = steps_;
    report.time = time();
    report.seconds = seconds_;
    report.contacts = contacts_.pairs().size();
    report.candidates = count_candidates(*exec_, contacts_.tested());
    measure_motion(*exec_, view(), gravity_, report);
    report.max_overlap = largest_overlap(*exec_, view(), box_, list_.view());
    report.state_hash = hash_state(exec_->download(position_.span()), exec_->download(velocity_.span()));
    report.stages = exec_->stage_times().stages();
    return report;
  }

  Bodies bodies() override {
    Bodies result;
    for (const V& p : exec_->download(position_.span())) result.position.push_back(widen(p));
    for (const V& v : exec_->download(velocity_.span())) result.velocity.push_back(widen(v));
    const auto radius = exec_->download(radius_.span()), inverse = exec_->download(inverse_mass_.span());
    for (size_t i = 0; i < result.position.size(); ++i) {
      result.radius.push_back(radius[radius.size() == 1 ? 0 : i]);
      result.mass.push_back(1.0 / inverse[inverse.size() == 1 ? 0 : i]);
    }
    return result;
  }

  int64_t steps() const override { return steps_; }
  double time() const override { return static_cast<double>(steps_) * dt_; }

 private:
  static BroadPhase make_broad_phase(const Scene& scene, const Settings& settings) {
    BroadPhaseParameters<V> parameters;
    parameters.box = {narrow<V>(scene.domain.min), narrow<V>(scene.domain.max), scene.domain.boundary};
    parameters.count = scene.bodies.size();
    for (const double radius : scene.bodies.radius) {
      parameters.largest_radius = std::max(parameters.largest_radius, static_cast<Real>(radius));
    }
    parameters.cell_size = settings.cell_size;
    if (settings.broadphase == "brute-force") return BruteForce<V, Exec>(parameters);
    return LinkedCell<V, Exec>(parameters);
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

  /// Finds the contacts of the present state, once: looking at them before a step saves the step the work.
  void detect() {
    if (is_detected_) return;
    std::visit(
        [&](auto& method) {
          method.prepare(*exec_, view());
          contacts_.find(*exec_, method.candidates(), view(), box_);
        },
        broad_phase_);
    is_detected_ = true;
  }

  void substep(Real dt) {
    const int64_t n = position_.size();
    detect();
    list_.build(*exec_, contacts_, view(), box_);

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
    const int64_t bad = first_outside(*exec_, view(), box_);
    if (bad < 0) return;
    const Vec3d p = widen(exec_->download(position_.span())[static_cast<size_t>(bad)]);
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
  Buffer<Real> radius_, inverse_mass_;
  BroadPhase broad_phase_;
  ContactFinder<V, Exec> contacts_;
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
