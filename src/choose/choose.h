// SPDX-License-Identifier: MIT
// Chooses the cheapest settings with which a scene shows what it needs (docs/choice.md).
//
//     numbers ──▶ rules ──▶ variants, each with its first rung ──▶ pilots ──▶ cheapest that holds ──▶ search
//     numbers.h   rules.h   candidates.h, search.h                 pilot.h                            detection.h
//
// Cost: the budget, and a second at most.
#pragma once

#include <cmath>

#include "choose/candidates.h"
#include "choose/pilot.h"
#include "choose/rules.h"

namespace ballpit {

inline constexpr double kEqualCosts = 0.01;  ///< [s] of computing; cheaper runs count as equal

struct ChoiceRequest {
  const Scene& scene;
  std::vector<GivenOption> given{};  ///< options that are kept; --response auto is none
  double budget = 5;                 ///< [s] for all pilots
  bool remeasure = false;            ///< measure the machine again
  std::stop_token stop{};            ///< ends the choice, by Interrupted
};

struct RuledOut {
  std::string method;  ///< of variants()
  std::string reason;
  std::string_view rule;
};

struct Attempt {
  std::string method;
  Settings settings;
  double cost = 0;                ///< [s] of computing for the needs' duration and all spheres, from its pilot
  std::vector<double> errors{};   ///< of each tolerance
  std::vector<bool> is_unseen{};  ///< of each tolerance: the pilot was too short to show it
  bool holds = false;
  bool may_hold = false;  ///< as far as its pilot, which was too short, has shown
  bool is_close = false;  ///< within the tolerances as far as its pilot ran, with or without the margin that is wanted
  double worst = 0;       ///< largest error by its tolerance
  double largest_overlap = 0;  ///< that its pilot saw, as a fraction of the smaller radius
  std::string remark{};        ///< why it has no errors: given up for its cost, stopped
  Seen seen{};                 ///< by its pilot

  /// Whether the error of tolerance k is known.
  bool knows(size_t k) const { return k < errors.size() && std::isfinite(errors[k]) && !is_unseen[k]; }
};

struct Choice {
  SceneNumbers numbers;
  EffectiveNeeds needs;
  std::vector<Tolerance> tolerances;
  std::vector<RuledOut> ruled_out;
  std::vector<Attempt> tried;      ///< in the order of the pilots
  std::optional<Attempt> chosen;   ///< empty if nothing holds
  std::optional<Attempt> nearest;  ///< where nothing holds: the one that comes nearest
  std::vector<Settings> dearer;    ///< to go on with where the choice turns out not to hold, cheapest first
  std::vector<std::string> unneeded;
  std::string reason;  ///< one sentence
  int64_t pilot_spheres = 0;
  bool is_out_of_time = false;  ///< the budget ended before all was tried
  double seconds = 0;           ///< [s] that it took
};

/// Throws Interrupted if the program is interrupted, or the choice asked to stop; UserError for options or [needs] that
/// are not allowed.
Choice choose(const ChoiceRequest& request);

/// "ballpit simulate SCENE --response …".
std::string command_of(std::string_view name, const Scene& scene, const std::vector<GivenOption>& given,
                       const Settings& settings);

}  // namespace ballpit
