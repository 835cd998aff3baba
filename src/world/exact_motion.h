// SPDX-License-Identifier: MIT
// Event-driven motion from a given state that can also go back in time.
//
//     kept    0 ········ 4n ········ 8n ········ 12n events     copies of the motion; if there are too many, every
//                          ◂── go_to: restored, then run on     second one is dropped
//
// Cost: that of event-driven motion; copies of n spheres every 4n events at first, later fewer, at most 64 MiB of them.
#pragma once

#include <memory>
#include <vector>

#include "event_driven/event_driven.h"
#include "methods/settings.h"

namespace ballpit {

/// What a stepped world is ahead of exact motion, for each sphere.
struct Lead {
  std::vector<Vec3d> position;  ///< [m] from the exact one, the nearest image
  std::vector<Vec3d> velocity;  ///< [m/s]
  double exact_speed = 0;       ///< [m/s] root mean square of the exact velocities
};

class ExactMotion {
 public:
  virtual ~ExactMotion() = default;

  /// Goes to a time [s] since the start, forward or back. Returns false if that takes more than `max_events`. Throws as
  /// EventDriven::run_until() does. With `log`, lists there the collisions of the way forward.
  virtual bool go_to(double time, int64_t max_events, std::vector<LoggedCollision>* log = nullptr) = 0;

  virtual double now() const = 0;                                            ///< [s] where go_to() has arrived
  virtual void lead(const Bodies& stepped, Lead& result) const = 0;          ///< of stepped bodies, at now()
  virtual Vec3d displacement(const Vec3d& from, const Vec3d& to) const = 0;  ///< [m] to the nearest image
  virtual int64_t collisions() const = 0;                                    ///< between spheres, so far
  virtual int64_t events() const = 0;                                        ///< so far
};

/// From the bodies of the scene. Throws RunError if that state is not valid.
std::unique_ptr<ExactMotion> make_exact_motion(const Scene& scene, const Settings& settings);

}  // namespace ballpit
