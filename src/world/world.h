// SPDX-License-Identifier: MIT
// A world steps a scene through time and shows itself: step() moves on, inspect() and report() only look.
// Many worlds may live at once; none shares anything with another.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bodies/body_snapshot.h"
#include "bodies/tally.h"
#include "exec/stage_times.h"
#include "methods/settings.h"
#include "scene/scene.h"
#include "world/inspection.h"
#include "world/pair_search.h"

namespace ballpit {

/// Figures of a world's present state, and of the way to it.
struct Report {
  int64_t count = 0;  ///< spheres
  int64_t steps = 0;
  double time = 0;                ///< [s] simulated
  double seconds = 0;             ///< [s] spent in step()
  std::vector<Stage> stages;      ///< where they were spent
  std::string broadphase;         ///< by name, also where settings ask for auto
  std::string broadphase_reason;  ///< why auto chose it; empty where it was asked for
  int64_t searches = 0;           ///< times that the broad phase searched; fewer than steps where there is a skin
  int64_t detection_bytes = 0;    ///< memory of broad and narrow phase
  int64_t body_bytes = 0;         ///< memory of positions, velocities, radii and masses
  int64_t motion_bytes = 0;       ///< memory of response, integrator, guard and tally
  int64_t candidates = 0;         ///< narrow-phase tests made to detect the contacts of the present state
  int64_t contacts = 0;           ///< overlapping pairs in the present state, walls not counted
  double kinetic_energy = 0;      ///< [J]
  double potential_energy = 0;    ///< [J] −Σ m·g·x, zero at the origin
  double elastic_energy = 0;      ///< [J] in springs of the penalty response
  Vec3d momentum{0.0};            ///< [kg·m/s]
  double max_overlap = 0;         ///< largest overlap, with spheres or walls, as a fraction of the smaller radius
  uint64_t state_hash = 0;        ///< of the bits of all positions and velocities
  int64_t events = 0;             ///< of the event-driven response: collisions and crossings of cells
  Tally tally;
};

/// What a world needs to be as it was: made by World::snapshot(), and of use to that world alone.
class Snapshot {
 public:
  virtual ~Snapshot() = default;
  virtual int64_t bytes() const = 0;
};

class World {
 public:
  virtual ~World() = default;

  /// Advances by dt. Throws RunError where a sphere is no longer inside the domain, naming it and the step.
  virtual void step() = 0;

  /// Copies of what the detection sees in the present state, with what is wanted beside. What has no meaning for a method
  /// stays empty. Throws RunError where there are too many candidates to list.
  virtual Inspection inspect(const Wanted& wanted = {}) = 0;

  virtual Report report() = 0;

  /// Finds contacts as these settings say from now on: broad phase, its parameters, skin. The motion goes on, by the bits that any
  /// method gives that misses nothing; times of stages start anew. False where a world has cells of its own.
  virtual bool detect_by(const Settings&) { return false; }

  virtual BodyShape shape() const = 0;

  /// Writes the present state where a vertex shader reads it; see BodyTarget.
  virtual void write_bodies(const BodyTarget& target) = 0;

  /// The present state, in double precision; starts the same world again.
  virtual Bodies bodies() = 0;

  /// The last state that passed the guard, and its time [s]: what is left where step() throws.
  virtual Bodies last_good() { return bodies(); }
  virtual double last_good_time() { return time(); }

  /// A copy of all that later bits follow from; bodies() alone is not enough for some (docs/model.md).
  virtual std::unique_ptr<Snapshot> snapshot() = 0;

  /// Puts the world back, also after step() threw: it goes on by the bits of the first time. Time spent stays counted.
  virtual void restore(const Snapshot& snapshot) = 0;

  virtual int64_t steps() const = 0;
  virtual double time() const = 0;  ///< [s]
};

/// A place where worlds run.
struct Backend {
  std::string name;                ///< "cpu"
  std::string unavailable_reason;  ///< empty where it can serve
  std::string description;         ///< "NVIDIA H100, compute capability 9.0"
  std::unique_ptr<World> (*make_world)(const Scene&, const Settings&);
  std::unique_ptr<PairSearch> (*make_pair_search)(const Settings&);
};

Backend cpu_backend();
Backend cuda_backend();  ///< defined by the CUDA library, or by its stub

}  // namespace ballpit
