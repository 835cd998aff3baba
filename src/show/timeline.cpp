// SPDX-License-Identifier: MIT
#include "show/timeline.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/error.h"
#include "core/interrupt.h"

namespace ballpit {

namespace {

constexpr int64_t kInterval =
    16;  // steps between keyframes at first: the guard's interval, after which snapshots are smallest
constexpr int64_t kMaxRecent = 64;  // snapshots
constexpr int64_t kRecentPart = 4;  // of the budget: a quarter

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Timeline::Timeline(World& world, double dt, int64_t budget, Acts* acts)
    : world_(world),
      acts_(acts),
      dt_(dt),
      budget_(budget),
      first_(world.steps()),
      furthest_(first_),
      interval_(kInterval) {
  keyframes_.put(first_, world_.snapshot());
  largest_ = keyframes_.bytes;
}

void Timeline::step() {
  // If all recent snapshots fit, they are so small that they cost little compared with a step.
  advance(has_room_for(kMaxRecent));
}

bool Timeline::go_to(int64_t step, const std::function<bool()>& stop) {
  const int64_t goal = std::clamp(step, first_, furthest_);
  const auto latest = latest_before(goal);
  if (step_now() < latest->first || step_now() > goal) world_.restore(*latest->second);
  while (step_now() < goal) {
    if (stop && stop()) return false;
    advance(goal - step_now() <= kMaxRecent && has_room_for(1));  // the user may step back next
  }
  return true;
}

void Timeline::advance(bool keeps_recent) {
  const int64_t before = step_now();
  try {
    acts_ ? void(acts_->step(world_)) : world_.step();
    world_.wait();  // so that an error belongs to this step
  } catch (const Interrupted&) {
    throw;  // the state is valid, and computing steps again would be interrupted again
  } catch (...) {
    world_.restore(*latest_before(before)->second);
    go_to(before);
    throw;
  }
  furthest_ = std::max(furthest_, step_now());
  remember(keeps_recent);
  if (after_step) after_step();
}

void Timeline::act(const Act& act) {
  const auto before = world_.snapshot();
  try {
    acts_->add(act, world_);
  } catch (...) {
    world_.restore(*before);
    throw;
  }
  const int64_t now = step_now();
  forget_from(now);
  furthest_ = now;
  if (now == first_) keyframes_.put(first_, world_.snapshot());
  remember(has_room_for(1));
}

void Timeline::forget_from(int64_t step) {
  for (Shelf* const shelf : {&keyframes_, &recent_}) {
    for (auto place = shelf->at.lower_bound(step); place != shelf->at.end();) place = shelf->drop(place);
  }
}

/// The latest snapshot at or before a step.
Timeline::Shelf::Place Timeline::latest_before(int64_t step) {
  const auto keyframe = std::prev(keyframes_.at.upper_bound(step)), after = recent_.at.upper_bound(step);
  if (after == recent_.at.begin() || std::prev(after)->first < keyframe->first) return keyframe;
  return std::prev(after);
}

bool Timeline::has_room_for(int64_t recent) const { return recent * largest_ <= budget_ / kRecentPart; }

/// Keeps a snapshot of the present state if a keyframe is due, or if recent ones are kept.
void Timeline::remember(bool keeps_recent) {
  const int64_t now = step_now();
  const bool is_keyframe = now % interval_ == 0;
  if (keyframes_.at.contains(now) || recent_.at.contains(now) || !(is_keyframe || keeps_recent)) return;
  auto snapshot = world_.snapshot();
  largest_ = std::max(largest_, snapshot->bytes());
  (is_keyframe ? keyframes_ : recent_).put(now, std::move(snapshot));
  thin_keyframes();
  thin_recent();
}

/// Drops every second keyframe, but never the first, until the rest fits.
void Timeline::thin_keyframes() {
  while (keyframes_.bytes > budget_ - budget_ / kRecentPart && keyframes_.at.size() > 1) {
    interval_ *= 2;
    for (auto place = std::next(keyframes_.at.begin()); place != keyframes_.at.end();) {
      place = place->first % interval_ == 0 ? std::next(place) : keyframes_.drop(place);
    }
  }
}

/// Drops the recent snapshots farthest from the present step until the rest fits.
void Timeline::thin_recent() {
  while (recent_.bytes > budget_ / kRecentPart || static_cast<int64_t>(recent_.at.size()) > kMaxRecent) {
    const auto first = recent_.at.begin(), last = std::prev(recent_.at.end());
    recent_.drop(step_now() - first->first >= last->first - step_now() ? first : last);
  }
}

void Timeline::Shelf::put(int64_t step, std::unique_ptr<Snapshot> snapshot) {
  bytes += snapshot->bytes();
  at.emplace(step, std::move(snapshot));
}

Timeline::Shelf::Place Timeline::Shelf::drop(Place place) {
  bytes -= place->second->bytes();
  return at.erase(place);
}

int Player::advance(Timeline& timeline, double elapsed, double share) {
  if (!is_running) return 0;
  const double dt = timeline.time_of(1);
  owed_ += elapsed * speed;
  const auto start = std::chrono::steady_clock::now();
  int steps = 0;
  while (owed_ >= dt) {
    if (steps > 0 && seconds_since(start) >= share) {
      owed_ = 0;  // too slow for the clock: drop the rest
      break;
    }
    if (!try_step(timeline)) return steps;
    owed_ -= dt;
    simulated_ += dt;
    ++steps;
  }
  return steps;
}

void Player::observe(double elapsed) {
  constexpr double kSample = 0.5;  // [s]
  if (!is_running) sampled_ = simulated_ = reached_ = 0;
  sampled_ += elapsed;
  if (sampled_ < kSample) return;
  reached_ = simulated_ / sampled_;
  sampled_ = simulated_ = 0;
}

void Player::step(Timeline& timeline) {
  is_running = false;
  owed_ = 0;
  try_step(timeline);
}

bool Player::try_step(Timeline& timeline) {
  if (!failure_.empty()) return is_running = false;
  const auto start = std::chrono::steady_clock::now();
  try {
    timeline.step();
  } catch (const RunError& error) {
    failure_ = error.what();
    return is_running = false;
  }
  step_times_.push_back(static_cast<float>(1e3 * seconds_since(start)));
  if (step_times_.size() > kKept) step_times_.pop_front();
  if (after_step) after_step();
  return true;
}

double Player::mean_step_time() const {
  if (step_times_.empty()) return 0;
  return std::accumulate(step_times_.begin(), step_times_.end(), 0.0) / double(step_times_.size());
}

}  // namespace ballpit
