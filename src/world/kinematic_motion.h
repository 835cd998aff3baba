// SPDX-License-Identifier: MIT
// The motion of the kinematic response.
#pragma once

#include "response/kinematic.h"
#include "world/velocity_motion.h"

namespace ballpit {

template <class V, class Exec>
std::unique_ptr<Motion<V, Exec>> make_kinematic_motion(const Scene& scene, const Settings& settings) {
  using Law = KinematicResponse<V, Exec>;
  return std::make_unique<VelocityMotion<V, Exec, Law>>(Law(scene.physics.restitution, scene.physics.wall_restitution),
                                                        settings.is_swept, scene.physics.wall_restitution);
}

}  // namespace ballpit
