// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "world/world.h"

namespace ballpit {

/// A world of hard spheres that move from event to event, in double precision on one thread (event_driven.h).
/// A step advances by settings.dt, which does not affect the motion.
std::unique_ptr<World> make_event_driven_world(const Scene& scene, const Settings& settings);

}  // namespace ballpit
