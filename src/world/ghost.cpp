// SPDX-License-Identifier: MIT
#include "world/ghost.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/interrupt.h"

namespace ballpit {

namespace {

constexpr int64_t kMaxEvents = 40, kFewEvents = 2000;  // of a sphere in a step, and in any case: more take too long
constexpr double kEventsPerSample = 1;                 // of each sphere: a sample then costs a fiftieth of them
constexpr int64_t kFew = 300;                          // spheres, of which samples cost little at any rate
constexpr size_t kFirstSamples = 32;                   // however few events they have: distances grow fastest at first
constexpr double kTolerance = 1e-6;                    // of a step: times that differ by less are equal
constexpr std::string_view kDeep =
    "spheres overlap by more than half a radius here; drop it at a moment with less overlap";
constexpr std::string_view kEndless = "exact motion ends here: where spheres rest on each other, collisions never end";

/// N·d³/V if this is a gas of equal elastic spheres in space without gravity, else 0.
double density_of_gas(const Scene& scene, const Bodies& bodies) {
  const auto are_equal = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
  };
  const Domain& domain = scene.domain;
  const Physics& physics = scene.physics;
  const bool is_gas = domain.dimensions == 3 && domain.boundary != Boundary::open_top && bodies.size() >= 20 &&
                      length(physics.gravity) == 0 && physics.restitution == 1 &&
                      (physics.wall_restitution == 1 || domain.boundary == Boundary::periodic);
  if (!is_gas || !are_equal(bodies.radius) || !are_equal(bodies.mass)) return 0;
  const Vec3d size = domain.max - domain.min;
  return double(bodies.size()) * std::pow(2 * bodies.radius.front(), 3) / (size.x * size.y * size.z);
}

}  // namespace

std::optional<double> e_folds_per_collision(double density) {
  struct Measured {
    double density, e_folds;
  };
  static constexpr std::array<Measured, 6> kMeasured{
      {{0.05, 3.95}, {0.1, 2.6}, {0.2, 1.65}, {0.3, 1.2}, {0.5, 0.8}, {0.7, 0.53}}};
  for (size_t k = 1; k < kMeasured.size(); ++k) {
    const Measured &low = kMeasured[k - 1], &high = kMeasured[k];
    if (!(density >= low.density && density <= high.density)) continue;
    const double part = std::log(density / low.density) / std::log(high.density / low.density);
    return low.e_folds + part * (high.e_folds - low.e_folds);
  }
  return std::nullopt;
}

Ghost::Ghost(const Scene& scene, const Settings& settings, World& world, double time)
    : domain_(scene.domain), dropped_(time), seen_(time), overlap_(world.report().max_overlap), lacks_from_(time) {
  if (overlap_ > kMaxOverlap) {
    lack_ = kDeep;
    return;
  }
  Scene start = scene;
  start.bodies = world.bodies();
  density_ = density_of_gas(start, start.bodies);
  try {
    motion_ = make_exact_motion(start, settings);
  } catch (const RunError&) {
    lack_ = kEndless;
    return;
  }
  fresh_watch_.emplace(start.bodies, start.physics.gravity);
  watch_ = fresh_watch_;
  samples_.push_back({dropped_, 0, 0});
  count_ = start.bodies.size();
}

/// False if exact motion does not reach that time.
bool Ghost::go_to(double time, double dt, std::vector<LoggedCollision>* log) {
  if (!motion_ || (!lack_.empty() && time >= lacks_from_)) return false;
  const double from = time < dropped_ + motion_->now() ? dropped_ : dropped_ + motion_->now();
  const auto steps = std::max<int64_t>(1, std::llround((time - from) / dt));
  try {
    if (motion_->go_to(time - dropped_, steps * (kMaxEvents * count_ + kFewEvents), log)) return true;
  } catch (const Interrupted&) {
    return false;  // the caller ends soon
  } catch (const RunError&) {
    // as below
  }
  lack_ = kEndless;
  lacks_from_ = time;
  return false;
}

void Ghost::follow(World& world, double time, double dt) {
  if (time <= seen_ + kTolerance * dt) return;
  const bool is_next = time - seen_ < (1 + kTolerance) * dt + kTolerance * dt;
  if (!is_next) watch_.reset();
  const double before = seen_;
  seen_ = time;
  ++steps_;
  const bool is_watching = watch_ && watch_->is_searching(), is_due = steps_ % stride_ == 0;
  if (!is_watching && !is_due) return;
  std::vector<LoggedCollision> collisions;
  if (is_watching && !go_to(before, dt)) return;  // in case it was shown at an earlier moment
  if (!go_to(time, dt, is_watching ? &collisions : nullptr)) return;
  const double events = double(motion_->events()) - sampled_;
  const bool is_cheap = count_ <= kFew || events >= kEventsPerSample * double(count_);
  const bool is_sampled = is_due && (is_cheap || samples_.size() < kFirstSamples);
  if (!is_watching && !is_sampled) return;
  const Bodies stepped = world.bodies();
  motion_->lead(stepped, lead_);
  if (is_sampled) keep(distance_at(time, stepped.radius));
  if (is_watching) watch_->step(time - dropped_, dt, stepped, *motion_, lead_, std::move(collisions));
}

void Ghost::keep(const GhostDistance& distance) {
  sampled_ = double(motion_->events());
  samples_.push_back(distance);
  if (samples_.size() < kMaxSamples) return;
  stride_ *= 2;
  size_t kept = 0;
  for (size_t k = 0; k < samples_.size(); k += 2) samples_[kept++] = samples_[k];
  samples_.resize(kept);
}

/// By the present lead.
GhostDistance Ghost::distance_at(double time, const std::vector<double>& radius) {
  distance_.resize(radius.size());
  GhostDistance result{time, 0, 0};
  for (size_t i = 0; i < radius.size(); ++i) {
    distance_[i] = length(lead_.position[i]) / radius[i];
    result.largest = std::max(result.largest, distance_[i]);
  }
  if (distance_.empty()) return result;
  const auto middle = distance_.begin() + std::ptrdiff_t(distance_.size() / 2);
  std::nth_element(distance_.begin(), middle, distance_.end());
  result.median = *middle;
  return result;
}

void Ghost::forget_after(double time) {
  while (samples_.size() > 1 && samples_.back().time > time) samples_.pop_back();
  if (seen_ <= time) return;
  // What was found later belongs to steps that will not come again. Only from the start on is the next one the first.
  if (watch_ && (!watch_->found() || dropped_ + watch_->found()->time > time)) watch_.reset();
  if (time <= dropped_) watch_ = fresh_watch_;
  seen_ = time;
}

GhostInspection Ghost::inspect(World& world, double time, double dt, bool is_exact) {
  follow(world, time, dt);
  GhostInspection result;
  result.dropped = dropped_;
  result.overlap = overlap_;
  result.is_exact = is_exact;
  for (const GhostDistance& sample : samples_) {
    if (sample.time < time - kTolerance * dt) result.curve.push_back(sample);
  }
  const bool is_there = go_to(time, dt);
  if (is_there) {
    const Bodies stepped = world.bodies();
    motion_->lead(stepped, lead_);
    result.curve.push_back(distance_at(time, stepped.radius));
    for (const Vec3d& lead : lead_.position) result.ahead.push_back(Vec3(-lead));
    add_growth(result, time);
  } else {
    result.lack = lack_;
  }
  result.is_unwatched = motion_ && !watch_;
  if (watch_ && watch_->found() && dropped_ + watch_->found()->time <= time) {
    result.wrong = *watch_->found();
    result.wrong->time += dropped_;
  }
  return result;
}

/// Γ, the collisions of a sphere in a second, times its e-folds for each of them.
void Ghost::add_growth(GhostInspection& seen, double time) const {
  const std::optional<double> e_folds = e_folds_per_collision(density_);
  const double elapsed = time - dropped_;
  if (!e_folds || !(elapsed > 0)) return;
  const double rate = 2.0 * double(motion_->collisions()) / double(count_) / elapsed;
  if (rate * elapsed < 1) return;
  seen.growth = *e_folds * rate;
  seen.growth_from = dropped_ + 1 / rate;
}

}  // namespace ballpit
