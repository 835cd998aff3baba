// SPDX-License-Identifier: MIT
#include "world/collision_watch.h"

#include <cmath>
#include <unordered_map>
#include <utility>

namespace ballpit {

namespace {

constexpr double kSlightPart = 0.01;  // of the mean speed
constexpr double kGravitySteps = 4;   // in which gravity changes a velocity by as much as a collision at rest may
constexpr double kBoundary = 1e-3;    // of a step: collisions so near its end may be in either step

/// How much of a change has been reached: 1 for all of it.
double part_of(const Vec3d& change, const Vec3d& reached) { return dot(reached, change) / dot(change, change); }

template <class Visit>
void each_body(const LoggedCollision& c, const Visit& visit) {
  visit(size_t(c.body), c.change);
  if (c.partner >= 0) visit(size_t(c.partner), c.partner_change);
}

}  // namespace

CollisionWatch::CollisionWatch(const Bodies& start, const Vec3d& gravity)
    : gravity_(gravity), stepped_velocity_(start.velocity), jumped_(start.velocity.size(), -kNever) {
  before_.position.resize(start.velocity.size(), Vec3d(0.0));
  before_.velocity.resize(start.velocity.size(), Vec3d(0.0));
}

CollisionWatch::Judged CollisionWatch::judged(const LoggedCollision& c) {
  const bool is_partner = dot(c.partner_change, c.partner_change) > dot(c.change, c.change);
  return {size_t(is_partner ? c.partner : c.body), is_partner ? c.partner_change : c.change};
}

void CollisionWatch::step(double time, double dt, const Bodies& stepped, const ExactMotion& exact, Lead& lead,
                          std::vector<LoggedCollision> collisions) {
  std::swap(now_, lead);
  slight_ = std::max(kSlightPart * now_.exact_speed, kGravitySteps * dt * length(gravity_));
  if (missing_) {
    follow(time, dt, stepped, exact);
  } else {
    judge(time, dt, std::move(collisions));
  }
  for (size_t i = 0; i < stepped_velocity_.size(); ++i) {
    const Vec3d jump = now_.velocity[i] - before_.velocity[i];
    if (dot(jump, jump) > slight_ * slight_) jumped_[i] = moment_of_jump(i, time, dt);
  }
  stepped_velocity_ = stepped.velocity;
  std::swap(before_, now_);
}

/// The stepped world's lead is what its velocity is ahead of the exact one's. It is Δv₁ + … + Δv_q before the step if
/// the stepped world has had the first q of a sphere's collisions early, and −Δv_p − … after the step if those from p
/// on have not come. q and p are those that fit best; for a single collision this decides at half of Δv.
void CollisionWatch::judge(double time, double dt, std::vector<LoggedCollision> collisions) {
  collisions.insert(collisions.begin(), carried_.begin(), carried_.end());
  carried_.clear();
  if (collisions.empty()) return;
  // Of each sphere that collides: its collisions so far, what they add up to, and how many of them fit best.
  struct Fit {
    Vec3d lead, sum{0.0};
    double off;
    int count = 0, best = 0;
    void add(const Vec3d& change) {
      sum += change;
      ++count;
      const double distance = dot(sum - lead, sum - lead);
      if (distance < off) off = distance, best = count;
    }
  };
  std::unordered_map<size_t, Fit> early, done;
  for (const LoggedCollision& c : collisions) {
    each_body(c, [&](size_t i, const Vec3d& change) {
      const Vec3d lead = before_.velocity[i];
      early.try_emplace(i, Fit{.lead = lead, .off = dot(lead, lead)});
      done.try_emplace(i, Fit{.lead = now_.velocity[i], .off = 0}).first->second.lead += change;
    });
  }
  for (auto& [i, fit] : done) fit.off = dot(fit.lead, fit.lead);
  for (const LoggedCollision& c : collisions) {
    each_body(c, [&](size_t i, const Vec3d& change) {
      early.at(i).add(change);
      done.at(i).add(change);
    });
  }
  std::unordered_map<size_t, int> number;  // of the collision, among those of its sphere
  for (const LoggedCollision& c : collisions) {
    each_body(c, [&](size_t i, const Vec3d&) { ++number[i]; });
    const Judged judged = CollisionWatch::judged(c);
    const size_t i = judged.body;
    if (!(length(judged.change) > slight_)) continue;
    if (time - c.time < kBoundary * dt) {
      carried_.push_back(c);
      continue;
    }
    const double early_by = c.time - jumped_[i];
    if (number[i] <= early.at(i).best && early_by > kBoundary * dt) {
      return find(c, Timing::early, std::isfinite(early_by) ? -early_by : 0);
    }
    if (number[i] > done.at(i).best) {
      missing_ = Missing{c, judged, stepped_velocity_[i], time - dt};
      return find(c, Timing::open, 0);
    }
  }
}

/// Whether the collision that has not come has come now, or will not come.
void CollisionWatch::follow(double time, double dt, const Bodies& stepped, const ExactMotion& exact) {
  const auto& [body, change] = missing_->judged;
  const Vec3d changed = stepped.velocity[body] - missing_->velocity - (time - missing_->time) * gravity_;
  if (part_of(change, changed) >= 0.5) {
    find(missing_->collision, Timing::late, moment_of_jump(body, time, dt) - missing_->collision.time);
  } else if (has_parted(stepped, exact)) {
    find(missing_->collision, Timing::missed, 0);
  }
}

/// Whether the two spheres, or sphere and wall, are apart in the stepped world and move apart.
bool CollisionWatch::has_parted(const Bodies& stepped, const ExactMotion& exact) const {
  const LoggedCollision& c = missing_->collision;
  const auto i = size_t(c.body);
  if (c.partner < 0) {
    const Vec3d inwards = c.change / length(c.change);
    const double gap = dot(stepped.position[i] - c.place, inwards) - stepped.radius[i];
    return gap > 0 && dot(stepped.velocity[i], inwards) > 0;
  }
  const auto j = size_t(c.partner);
  const Vec3d d = exact.displacement(stepped.position[i], stepped.position[j]);
  return length(d) > stepped.radius[i] + stepped.radius[j] && dot(d, stepped.velocity[j] - stepped.velocity[i]) > 0;
}

/// [s] When a sphere's lead changed in the step that ends now, if it did so at once: x = x₀ + v₀·dt + Δv·(t − t_jump).
/// Collisions that both motions have cancel out.
double CollisionWatch::moment_of_jump(size_t i, double time, double dt) const {
  const Vec3d jump = now_.velocity[i] - before_.velocity[i];
  const Vec3d moved = now_.position[i] - before_.position[i] - dt * before_.velocity[i];
  return time - std::clamp(part_of(jump, moved), 0.0, dt);
}

void CollisionWatch::find(const LoggedCollision& c, Timing timing, double late_by) {
  found_ = WrongCollision{timing, c.time, late_by, c.body, c.partner, Vec3(c.place)};
}

}  // namespace ballpit
