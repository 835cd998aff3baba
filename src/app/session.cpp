// SPDX-License-Identifier: MIT
#include "app/session.h"

#include <cmath>
#include <sstream>

#include "app/backends.h"
#include "core/error.h"
#include "render/overlays/overlay.h"
#include "scene/catalog.h"

namespace ballpit {

Session::Session(std::string_view scene, const std::vector<GivenOption>& given, bool keeps_tally) {
  Settings overrides;
  apply_given(overrides, given);
  scene_ = load_scene(scene, {overrides.count, overrides.seed});
  settings_ = combine(scene_.defaults, given);
  settings_.keeps_tally = keeps_tally;
  warn_of_small_cells(settings_);
  const Backend backend = select_backend(settings_.backend, settings_.response);
  backend_ = backend.name;
  world_ = backend.make_world(scene_, settings_);
  scene_.bodies = {};  // the world has them now
}

int64_t Session::steps_until(double time) const {
  constexpr double kMostSteps = 1e15;  // more would not end, and their number leaves the integers
  const double steps = time / settings_.dt;
  if (!(steps <= kMostSteps)) {
    std::ostringstream message;
    message << "--dt: found " << settings_.dt << ", which makes " << steps << " steps of " << time << " s, allowed "
            << kMostSteps << " steps";
    throw UserError(message.str());
  }
  return static_cast<int64_t>(std::llround(steps)) - world_->steps();
}

FrameView Session::view_of(const Inspection& inspection, float aspect, const std::vector<std::string>& overlays) const {
  const Domain& domain = scene_.domain;
  const Vec3 low(domain.min), high(domain.max);
  return {inspection,
          {low, high, domain.dimensions, domain.boundary == Boundary::open_top},
          leave_room_below(frame_box(low, high, domain.dimensions, aspect), room_below(overlays, inspection)),
          overlays};
}

}  // namespace ballpit
