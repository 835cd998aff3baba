// SPDX-License-Identifier: MIT
#include "choose/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "methods/methods.h"
#include "methods/number_range.h"

namespace ballpit {

namespace {

constexpr int kFirstSteps = 60;
constexpr int kExactSteps = 600;        // of event-driven motion: only frames, which it computes at any time
constexpr double kShortContact = 1e-7;  // of the duration; collisions that follow sooner lose no energy
constexpr double kLargestStep = 10, kSmallestStep = 1e-12;  // [s] of --dt

constexpr std::array kVariants{
    Variant{"event-driven", Response::event_driven, [](Settings&) {}, 1},
    Variant{"position-based", Response::position_based, [](Settings&) {}, 1.2},
    Variant{"impulse, 1 iteration", Response::impulse, [](Settings& s) { s.iterations = 1; }, 1},
    Variant{"impulse", Response::impulse, [](Settings& s) { s.iterations = 4; }, 1.3},
    Variant{"impulse, 16 iterations", Response::impulse, [](Settings& s) { s.iterations = 16; }, 2.5},
    Variant{"impulse, swept", Response::impulse,
            [](Settings& s) {
              s.iterations = 4;
              s.is_swept = true;
            },
            2},
    Variant{"penalty", Response::penalty, [](Settings& s) { s.integrator = Integrator::symplectic_euler; }, 1},
    Variant{"penalty, velocity-verlet", Response::penalty,
            [](Settings& s) { s.integrator = Integrator::velocity_verlet; }, 1.6},
    Variant{"kinematic", Response::kinematic, [](Settings&) {}, 0.9},
};

/// Whether two variants differ in these settings.
bool are_same(const Settings& a, const Settings& b) {
  return a.response == b.response && iterations_of(a) == iterations_of(b) && a.is_swept == b.is_swept &&
         integrator_of(a) == integrator_of(b);
}

double step_at(int rung, bool is_exact, double duration) {
  if (duration <= 0) return 1.0 / 240;
  const double first = std::max<double>(is_exact ? kExactSteps : kFirstSteps, std::ceil(duration / kLargestStep));
  const double steps = is_exact ? first : std::round(first * std::pow(2.0, rung / 2.0));
  return std::max(kSmallestStep, duration / steps);
}

}  // namespace

std::span<const Variant> variants() { return kVariants; }

bool is_given(const std::vector<GivenOption>& given, std::string_view name) {
  return std::ranges::any_of(given, [&](const GivenOption& option) { return option.name == name; });
}

Settings base_settings(const Scene& scene, const std::vector<GivenOption>& given) {
  Settings settings;
  settings.broadphase = BroadPhase::automatic;
  for (const DefaultOption& option : scene.defaults) {
    if (option.key == "max-overlap" || option.key == "max-energy") {
      apply_setting(settings, option.key, option.value, option.where);
    }
  }
  for (const GivenOption& option : given) apply_setting(settings, option.name, option.value, "--" + option.name);
  return settings;
}

std::optional<Settings> settings_at(const Variant& variant, int rung, const Settings& base,
                                    const std::vector<GivenOption>& given, double duration) {
  Settings settings = base;
  settings.response = variant.response;
  variant.apply(settings);
  const Settings own = settings;
  for (const GivenOption& option : given) {
    if (option.name == "response" && option.value == name_of(Response::automatic)) continue;
    if (!goes_with(variant.response, option.name, option.value)) return std::nullopt;
    apply_setting(settings, option.name, option.value, "--" + option.name);
  }
  if (!are_same(own, settings)) {
    // One of the variants of a response stands for options that are given.
    if (settings.response != variant.response) return std::nullopt;
    const auto first = std::ranges::find(kVariants, variant.response, &Variant::response);
    if (first->name != variant.name) return std::nullopt;
  }
  if (is_given(given, "dt")) return rung == 0 ? std::optional(settings) : std::nullopt;
  const bool is_exact = variant.response == Response::event_driven;
  if (is_exact && rung > 0) return std::nullopt;
  if (is_exact && !is_given(given, "contact-duration"))
    settings.contact_duration = std::min(1.0, kShortContact * duration);
  settings.dt = std::min(kLargestStep, step_at(rung, is_exact, duration) * settings.substeps);
  return settings;
}

std::vector<GivenOption> options_of(const Settings& settings, const std::vector<DefaultOption>& defaults) {
  const Method& response = find_method(settings.response);
  const bool is_exact = settings.response == Response::event_driven;
  const Method& broad_phase = find_method(settings.broadphase);
  const auto is_wanted = [&](const SettingInfo& info) {
    const std::string_view name = info.name;
    if (name == "response" || name == "dt") return true;
    if (name == "broadphase" || name == "precision" || name == "threads" || name == "skin") return !is_exact;
    const bool is_default = info.get(settings) == info.get(Settings{});
    if (is_default && std::ranges::find(defaults, name, &DefaultOption::key) == defaults.end()) return false;
    if (name == "substeps") return !is_exact;
    if (name == "integrator") return settings.response == Response::penalty;
    if (name == "cell-size" || name == "table" || name == "axis") return !is_exact && uses(broad_phase, name);
    return uses(response, name);
  };
  std::vector<GivenOption> options;
  for (const SettingInfo& info : setting_table()) {
    std::string value = info.get(settings);
    if (info.name == "skin") value = typed(skin_of(settings));
    if (info.name == "cell-size" && value.empty()) value = typed(1);  // where the scene has another one
    if (info.name == "iterations") value = typed(iterations_of(settings));
    if (is_wanted(info) && !value.empty()) options.push_back({std::string(info.name), value});
  }
  if (settings.backend != BackendName::automatic)
    options.push_back({"backend", std::string(name_of(settings.backend))});
  return options;
}

std::string typed(const std::vector<GivenOption>& options) {
  std::string text;
  for (const GivenOption& option : options) text += (text.empty() ? "--" : " --") + option.name + " " + option.value;
  return text;
}

}  // namespace ballpit
