// SPDX-License-Identifier: MIT
// Speed against accuracy, live: all settings that were played are trials with a cost and errors, so that the panel can
// chart the effect of a change. The numbers are those of `ballpit simulate --json`.
//
//     error │ ×            × trials so far, ● the present one, which moves during play
//           │    ●         front: trials that no other trial beats in both
//           └────────── cost
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "choose/needs_meter.h"
#include "show/options.h"
#include "world/world.h"

namespace ballpit {

/// Settings, and their cost and errors so far.
struct Played {
  std::vector<GivenOption> given;
  Physics physics;
  int64_t steps = 0;
  double time = 0;     ///< [s] simulated
  double seconds = 0;  ///< [s] of computing time
  double overlap = 0;  ///< the largest seen, of the smaller radius
  double drift = 0;    ///< the largest change of energy seen, as a fraction of that when the trial began or resumed

  /// [s] of computing time for a simulated second.
  double cost() const { return time > 0 ? seconds / time : 0; }

  /// The options as typed: "--dt 0.01 --response penalty"; "as the scene says" without any.
  std::string label() const;
};

/// An error to chart.
struct PlayedError {
  std::string_view name, label;
  double Played::*value;
};
std::span<const PlayedError> played_errors();

class TradeOff {
 public:
  static constexpr int64_t kMinSteps = 10;  ///< steps of a trial that is kept

  /// Starts a trial, or resumes the one of the same settings. Drops the one before if it has fewer than kMinSteps
  /// steps.
  void begin(const std::vector<GivenOption>& given, const Physics& physics);

  /// Adds the time from the last observed state to this later one to the present trial.
  void observe(const Report& report);

  /// The next state does not follow from the one observed before.
  void interrupt() { last_.reset(); }

  /// Drops all trials, because they cannot be compared with the next ones.
  void clear();

  const std::vector<Played>& trials() const { return trials_; }
  int current() const { return current_; }  ///< −1 before the first

  std::optional<Played> prediction;  ///< what a choice expects of its settings; not played

  /// Trials that no other trial beats in both cost and this error, ordered by cost.
  std::vector<int> front(const PlayedError& error) const;

 private:
  std::vector<Played> trials_;
  int current_ = -1;
  std::optional<Report> last_;
  double start_energy_ = 0;  // [J]
};

}  // namespace ballpit
