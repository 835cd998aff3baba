// SPDX-License-Identifier: MIT
// A substep, whole, for each kind of response: where it stands between detection and integration.
//
//     velocities   contacts ──▶ kick ──▶ respond ──▶ drift               velocity_substepper.h: kinematic, impulse
//     forces       integrator { candidates ──▶ forces }                    force_substepper.h: penalty
//     positions    kick ──▶ drift ──▶ contacts there, and near ones ──▶ respond         position_substepper.h: position-based
//
// A world sees this interface alone. Each kind of motion is compiled by itself, so that a change of one response
// compiles that response anew and nothing else.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "world/step_state.h"
#include "world/tally_on.h"

namespace ballpit {

template <class V, class Exec>
class Substepper {
 public:
  virtual ~Substepper() = default;

  /// Moves all bodies on by dt [s].
  virtual void substep(StepState<V, Exec>& state, TallyKeeper<V, Exec>& tally, Scalar<V> dt) = 0;

  /// [J] in springs, for the present state.
  virtual double elastic_energy(StepState<V, Exec>&) const { return 0; }

  /// What it keeps for each body from substep to substep.
  virtual std::vector<typename Exec::template Buffer<V>*> kept() { return {}; }

  /// Numbers that a snapshot holds beside that.
  virtual std::vector<int64_t*> counters() { return {}; }

  virtual int64_t bytes() const = 0;
};

// Each is defined in the header named after its kind of motion.
template <class V, class Exec>
std::unique_ptr<Substepper<V, Exec>> make_kinematic_substepper(const Scene& scene, const Settings& settings);
template <class V, class Exec>
std::unique_ptr<Substepper<V, Exec>> make_impulse_substepper(const Scene& scene, const Settings& settings);
template <class V, class Exec>
std::unique_ptr<Substepper<V, Exec>> make_penalty_substepper(const Scene& scene, const Settings& settings);
template <class V, class Exec>
std::unique_ptr<Substepper<V, Exec>> make_position_based_substepper(const Scene& scene, const Settings& settings);

template <class V, class Exec>
std::unique_ptr<Substepper<V, Exec>> make_substepper(const Scene& scene, const Settings& settings) {
  if (settings.response == Response::kinematic) return make_kinematic_substepper<V, Exec>(scene, settings);
  if (settings.response == Response::position_based) return make_position_based_substepper<V, Exec>(scene, settings);
  if (settings.response == Response::penalty) return make_penalty_substepper<V, Exec>(scene, settings);
  return make_impulse_substepper<V, Exec>(scene, settings);
}

}  // namespace ballpit
