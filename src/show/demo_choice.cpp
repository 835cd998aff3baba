// SPDX-License-Identifier: MIT
// The cheapest settings that are good enough for a demonstration: chosen in the background from its present state,
// while it goes on, and then used in one change.
#include <algorithm>
#include <array>

#include "show/demo.h"

namespace ballpit {

namespace {

constexpr double kBudget = 2;  // [s]

bool is_one_of(const std::vector<GivenOption>& options, const GivenOption& option) {
  return std::ranges::any_of(
      options, [&](const GivenOption& other) { return other.name == option.name && other.value == option.value; });
}

/// Whether an option belongs to the method, which is to be chosen, and not to the scene, the machine or the run. A slider
/// that was moved, or a choice before this one, must not bind it.
bool is_of_method(const GivenOption& option) {
  constexpr std::array<std::string_view, 7> kOthers{"count",   "seed",        "mass-ratio", "backend",
                                                    "threads", "max-overlap", "max-energy"};
  return std::ranges::find(kOthers, option.name) == kOthers.end();
}

}  // namespace

void Demo::choose_cheapest() {
  touch();
  if (is_choosing()) return background_.abandon();
  if (is_comparing()) return say("nothing is chosen while broad phases are compared");
  message_.clear();
  Scene scene = session.scene();
  scene.bodies = session.world().bodies();
  background_.begin(std::move(scene), kept_by_choice(), kBudget);
}

/// The options that people gave, not a choice before.
std::vector<GivenOption> Demo::kept_by_choice() const {
  std::vector<GivenOption> kept = session.given();
  std::erase_if(kept, [&](const GivenOption& option) { return is_of_method(option) || is_one_of(chosen_, option); });
  return kept;
}

void Demo::take_choice(std::optional<BackgroundChoice::Result> result) {
  if (!result) return;
  touch();
  if (!result->choice) {
    message_ = result->failure;
    return;
  }
  choice_ = std::move(result->choice);
  if (choice_->chosen) {  // else what was there before stays
    const std::vector<GivenOption> kept = kept_by_choice(), given = options_by(*choice_);
    change([&] {
      session.take(given, session.scene().physics);
      player.forget_times();
      chosen_ = given;
      std::erase_if(chosen_, [&](const GivenOption& option) { return is_one_of(kept, option); });
    });
  }
  predict(*choice_);
}

/// The settings of a choice as options, with those that it keeps.
std::vector<GivenOption> Demo::options_by(const Choice& choice) const {
  std::vector<GivenOption> options = options_of(choice.chosen->settings, session.scene().defaults);
  for (const GivenOption& option : kept_by_choice()) {
    if (std::ranges::find(options, option.name, &GivenOption::name) == options.end()) options.push_back(option);
  }
  return options;
}

/// Marks in the chart what a choice expects of its settings.
void Demo::predict(const Choice& choice) {
  trade_off.prediction.reset();
  const double duration = choice.needs.needs.duration;
  if (!choice.chosen || choice.chosen->cost <= 0 || duration <= 0) return;
  const Attempt& best = *choice.chosen;
  trade_off.prediction = Played{.given = options_by(choice),
                                .physics = session.scene().physics,
                                .time = duration,
                                .seconds = best.cost,
                                .overlap = best.seen.overlap,
                                .drift = best.seen.drift};
}

/// Another scene, or other spheres or physics, need another choice.
void Demo::forget_choice() {
  background_.abandon();
  choice_.reset();
  trade_off.prediction.reset();
}

}  // namespace ballpit
