// SPDX-License-Identifier: MIT
// Makes the world that a scene and its settings ask for: two or three dimensions, single or double precision.
#pragma once

#include "world/world.h"

namespace ballpit {

/// A world of one vector type on an executor; defined in world_on.h.
template <class V, class Exec>
std::unique_ptr<World> make_world_of(std::unique_ptr<Exec> exec, const Scene& scene, const Settings& settings);

template <class Exec>
std::unique_ptr<World> make_world_on(std::unique_ptr<Exec> exec, const Scene& scene, const Settings& settings) {
  const bool is_planar = scene.domain.dimensions == 2;
  if (settings.precision == Precision::float64) {
    return is_planar ? make_world_of<Vec2d>(std::move(exec), scene, settings)
                     : make_world_of<Vec3d>(std::move(exec), scene, settings);
  }
  return is_planar ? make_world_of<Vec2>(std::move(exec), scene, settings)
                   : make_world_of<Vec3>(std::move(exec), scene, settings);
}

/// A world of hard spheres that move from event to event (event_driven.h). The length of a step does not affect the motion.
std::unique_ptr<World> make_event_driven_world(const Scene& scene, const Settings& settings);

}  // namespace ballpit
