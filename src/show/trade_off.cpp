// SPDX-License-Identifier: MIT
#include "show/trade_off.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ballpit {

namespace {

bool is_same(const Physics& a, const Physics& b) {
  return a.restitution == b.restitution && a.wall_restitution == b.wall_restitution && a.stiffness == b.stiffness;
}

bool is_same(const std::vector<GivenOption>& a, const std::vector<GivenOption>& b) {
  return std::is_permutation(a.begin(), a.end(), b.begin(), b.end(), [](const GivenOption& x, const GivenOption& y) {
    return x.name == y.name && x.value == y.value;
  });
}

}  // namespace

std::string Played::label() const {
  std::string text;
  for (const GivenOption& option : given) {
    text += fmt::format("{}--{} {}", text.empty() ? "" : " ", option.name, option.value);
  }
  return text.empty() ? "as the scene says" : text;
}

std::span<const PlayedError> played_errors() {
  static constexpr std::array<PlayedError, 2> kTable{{
      {"overlap", "largest overlap, of a radius", &Played::overlap},
      {"drift", "change of energy, of its start", &Played::drift},
  }};
  return kTable;
}

void TradeOff::begin(const std::vector<GivenOption>& given, const Physics& physics) {
  if (current_ >= 0 && trials_[static_cast<size_t>(current_)].steps < kMinSteps)
    trials_.erase(trials_.begin() + current_);
  const auto found = std::find_if(trials_.begin(), trials_.end(), [&](const Played& trial) {
    return is_same(trial.given, given) && is_same(trial.physics, physics);
  });
  current_ = static_cast<int>(found - trials_.begin());
  if (found == trials_.end()) trials_.push_back({given, physics});
  interrupt();
}

void TradeOff::observe(const Report& report) {
  if (current_ < 0) return;
  Played& trial = trials_[static_cast<size_t>(current_)];
  const double energy = energy_of(report);
  if (!last_) {
    start_energy_ = energy;
  } else if (report.steps > last_->steps) {
    trial.steps += report.steps - last_->steps;
    trial.time += report.time - last_->time;
    trial.seconds += report.seconds - last_->seconds;
    trial.overlap = std::max(trial.overlap, report.max_overlap);
    if (start_energy_ != 0) trial.drift = std::max(trial.drift, std::fabs((energy - start_energy_) / start_energy_));
  }
  last_ = report;
}

void TradeOff::clear() {
  trials_.clear();
  prediction.reset();
  current_ = -1;
  interrupt();
}

std::vector<int> TradeOff::front(const PlayedError& error) const {
  const auto at = [&](int k) {
    const Played& trial = trials_[static_cast<size_t>(k)];
    return std::pair(trial.cost(), trial.*error.value);
  };
  std::vector<int> order;
  for (int k = 0; k < static_cast<int>(trials_.size()); ++k) {
    if (trials_[static_cast<size_t>(k)].steps >= kMinSteps) order.push_back(k);
  }
  std::sort(order.begin(), order.end(), [&](int a, int b) { return at(a) < at(b); });
  std::vector<int> front;
  for (const int k : order) {
    if (front.empty() || at(k).second < at(front.back()).second) front.push_back(k);
  }
  return front;
}

}  // namespace ballpit
