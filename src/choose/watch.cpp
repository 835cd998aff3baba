// SPDX-License-Identifier: MIT
#include "choose/watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numbers.h"
#include "core/phrase.h"

namespace ballpit {

namespace {

std::string text(double value) { return local_number(three_digits(value)); }

/// The largest overlap that the needs allow during a run. Where they limit it at the end only, a run may overlap twice as
/// much as its pilot did before that: a pilot looks now and then, and may be a part of the scene.
double allowed_during(const Needs& needs, const Attempt& chosen) {
  constexpr double kMoreThanPilot = 2;
  if (needs.max_overlap_ever) return *needs.max_overlap_ever;
  if (!needs.max_overlap) return std::numeric_limits<double>::infinity();
  return std::max(*needs.max_overlap, kMoreThanPilot * chosen.largest_overlap);
}

}  // namespace

Watch::Watch(const Scene& scene, const Choice& choice, World& world)
    : domain_(scene.domain),
      needs_(choice.needs.needs),
      tolerances_(choice.tolerances),
      meter_(scene, needs_, world),
      allowed_overlap_(allowed_during(needs_, *choice.chosen)),
      numbers_(choice.numbers),
      dearer_(choice.dearer.begin(), choice.dearer.end()) {
  accept(world);
}

bool Watch::is_end(const World& world) const { return world.time() >= needs_.duration * (1 - 1e-9); }

std::string Watch::breach(World& world, const Settings& settings) const {
  const std::vector<double> errors = meter_.errors(world, {});
  for (size_t k = 0; k < tolerances_.size(); ++k) {
    const std::string& name = tolerances_[k].name;
    // What counts at the end is only a sign of trouble before it, and none where nothing else could be done.
    const bool is_early = !is_end(world) && (name == "max_overlap" || name == "max_speed");
    const bool is_sign = name == "max_overlap" && !dearer_.empty();
    const double allowed = !is_early ? tolerances_[k].allowed : is_sign ? allowed_overlap_ : INFINITY;
    if (errors[k] > allowed) return phrase("{} {}, allowed {}", name, text(errors[k]), text(allowed));
  }
  if (settings.response == Response::event_driven || settings.is_swept || dearer_.empty()) return "";
  double fastest = 0;
  for (const Vec3d& v : world.bodies().velocity) fastest = std::max(fastest, length(v));
  SceneNumbers now = numbers_;
  now.largest_speed = fastest;
  const double flight = now.flight(settings.dt / settings.substeps);
  if (flight <= 1) return "";
  return phrase("the fastest sphere moves {} diameters in a step, so contacts may be missed", text(flight));
}

void Watch::accept(World& world) {
  good_ = world.snapshot();
  good_steps_ = world.steps();
}

void Watch::go_back(World& world) const { world.restore(*good_); }

std::optional<Settings> Watch::next() {
  if (dearer_.empty()) return std::nullopt;
  Settings settings = dearer_.front();
  dearer_.pop_front();
  return settings;
}

}  // namespace ballpit
