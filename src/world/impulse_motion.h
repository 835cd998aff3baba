// SPDX-License-Identifier: MIT
// The motion of the impulse response.
#pragma once

#include "response/impulse.h"
#include "world/velocity_motion.h"

namespace ballpit {

// Old overlap is removed at most as fast as a body falls in this many steps: enough to carry a heap of as many layers.
inline constexpr double kPushSteps = 100;

template <class Real>
ImpulseParameters<Real> impulse_parameters(const Physics& physics, const Settings& settings) {
  const double gravity = length(physics.gravity);
  ImpulseParameters<Real> parameters{static_cast<Real>(physics.restitution),
                                     static_cast<Real>(physics.wall_restitution)};
  parameters.push_limit = static_cast<Real>(kPushSteps * gravity * settings.dt / settings.substeps);
  parameters.correction = gravity > 0 ? Real(0) : Real(0.4);
  if (settings.iterations) parameters.iterations = *settings.iterations;
  parameters.is_by_colour = settings.solver == Solver::gauss_seidel;
  if (settings.correction != Correction::split) {
    parameters.push = parameters.foresight = parameters.slop = 0;
    parameters.entered = parameters.correction = settings.correction == Correction::surface ? Real(1) : Real(0);
  }
  return parameters;
}

template <class V, class Exec>
std::unique_ptr<Motion<V, Exec>> make_impulse_motion(const Scene& scene, const Settings& settings) {
  using Law = ImpulseResponse<V, Exec>;
  return std::make_unique<VelocityMotion<V, Exec, Law>>(Law(impulse_parameters<Scalar<V>>(scene.physics, settings)),
                                                        settings.is_swept, scene.physics.wall_restitution);
}

}  // namespace ballpit
