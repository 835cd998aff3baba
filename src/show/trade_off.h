// SPDX-License-Identifier: MIT
// Speed against accuracy, live: each choice of settings that was played is a trial with its cost and its errors, so that the panel can
// chart what a change of sliders bought. The figures are those of `ballpit simulate --json`.
//
//     error │ ×            × trials so far, ● the present one, which moves while it is played
//           │    ●         front: trials that no other beats in both
//           └────────── cost
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "show/given_options.h"
#include "world/world.h"

namespace ballpit {

/// Settings, and what they came to so far.
struct Played {
  std::vector<GivenOption> given;
  Physics physics;
  int64_t steps = 0;
  double time = 0;     ///< [s] simulated
  double seconds = 0;  ///< [s] that it took
  double overlap = 0;  ///< the largest seen, of the smaller radius
  double drift = 0;    ///< the largest change of energy seen, of what it was when the trial began or went on

  /// [s] computed for a simulated second.
  double cost() const { return time > 0 ? seconds / time : 0; }

  /// As it would be typed: "--dt 0.01 --response penalty"; "as the scene says" where nothing is given.
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
  static constexpr int64_t kFewest = 10;  ///< steps that make a trial worth keeping

  /// These settings from now on. A trial of the same settings goes on; one of fewer steps than kFewest is dropped.
  void begin(const std::vector<GivenOption>& given, const Physics& physics);

  /// The present state, later than the one observed before; what lies between counts for the present trial.
  void observe(const Report& report);

  /// The next state does not follow from the one observed before.
  void interrupt() { last_.reset(); }

  /// Nothing that is here can be compared to what follows.
  void clear();

  const std::vector<Played>& trials() const { return trials_; }
  int current() const { return current_; }  ///< −1 before the first

  /// Trials that no other beats in cost and in this error, by cost.
  std::vector<int> front(const PlayedError& error) const;

 private:
  /// Of a state.
  struct Seen {
    int64_t steps;
    double time, seconds;  // [s]
  };

  std::vector<Played> trials_;
  int current_ = -1;
  std::optional<Seen> last_;
  double start_energy_ = 0;  // [J]
};

}  // namespace ballpit
