// SPDX-License-Identifier: MIT
#include "show/player.h"

#include <chrono>
#include <numeric>

#include "core/error.h"

namespace ballpit {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

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
    ++steps;
  }
  return steps;
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
  return true;
}

double Player::mean_step_time() const {
  if (step_times_.empty()) return 0;
  return std::accumulate(step_times_.begin(), step_times_.end(), 0.0) / double(step_times_.size());
}

}  // namespace ballpit
