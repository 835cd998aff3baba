// SPDX-License-Identifier: MIT
// The conditions that rule a method out, one row each, with formula and source. The program uses the same rows to
// choose a method, to find the step at which its pilots start, and to warn of a run that cannot work. docs/choice.md
// lists them with commands that show the failures.
#pragma once

#include <span>

#include "choose/numbers.h"

namespace ballpit {

/// What a rule judges.
struct RuleCase {
  const Scene& scene;
  const Needs& needs;
  const SceneNumbers& numbers;
  const Settings& settings;

  double step() const { return settings.dt / settings.substeps; }  ///< h [s]
};

enum class RuleKind {
  method,   ///< holds for any step
  step,     ///< forbids a step
  estimate  ///< guesses the step at which a tolerance is met; pilots find the true one
};

struct Rule {
  std::string_view name;
  RuleKind kind;
  bool warns;                ///< also before a run whose settings were given
  std::string_view methods;  ///< that it concerns, for the reader
  std::string_view formula;
  std::string_view source;
  std::string (*objection)(const RuleCase&);  ///< why the settings cannot serve, with figures; empty if they can
};

std::span<const Rule> rules();

/// The first objection of a rule that `kinds` selects, with the rule; null if there is none.
struct Objection {
  const Rule* rule = nullptr;
  std::string reason{};
  explicit operator bool() const { return rule != nullptr; }
};
Objection first_objection(const RuleCase& c, std::initializer_list<RuleKind> kinds);

/// What is wrong with a run of these settings, one line each: "--dt 0.01: …". Empty if it can work.
std::vector<std::string> warnings_of(const Scene& scene, const Settings& settings);

}  // namespace ballpit
