// SPDX-License-Identifier: MIT
// A world simulates a scene: step() advances it, inspect() and report() show it. Worlds share nothing with each other.
#pragma once

#include <memory>

#include "bodies/tally.h"
#include "exec/stage_times.h"
#include "methods/settings.h"
#include "scene/scene.h"
#include "world/inspection.h"
#include "world/pair_search.h"

namespace ballpit {

/// Figures of a world's present state, and of the run so far.
struct Report {
  int64_t count = 0;  ///< spheres
  int64_t steps = 0;
  double time = 0;                ///< [s] simulated
  double seconds = 0;             ///< [s] spent in step()
  std::vector<Stage> stages;      ///< time by stage
  std::string broadphase;         ///< by name, never auto
  std::string broadphase_reason;  ///< why auto chose it, or empty
  int64_t searches = 0;           ///< by the broad phase; fewer than steps if there is a skin
  int64_t detection_bytes = 0;    ///< memory of broad and narrow phase
  int64_t body_bytes = 0;         ///< memory of positions, velocities, radii and masses
  int64_t motion_bytes = 0;       ///< memory of response, integrator, guard and tally
  int64_t candidates = 0;         ///< pairs tested to find the present contacts
  int64_t contacts = 0;           ///< pairs of spheres in contact
  double kinetic_energy = 0;      ///< [J]
  double potential_energy = 0;    ///< [J] −Σ m·g·x, zero at the origin
  double elastic_energy = 0;      ///< [J] in springs of the penalty response
  Vec3d momentum{0.0};            ///< [kg·m/s]
  double max_overlap = 0;         ///< largest overlap, with spheres or walls, as a fraction of the smaller radius
  uint64_t state_hash = 0;        ///< of the bits of all positions and velocities
  int64_t events = 0;             ///< of the event-driven response: collisions and crossings of cells
  Tally tally;
};

/// A saved state of a world, from World::snapshot(); only that world can restore it.
class Snapshot {
 public:
  virtual ~Snapshot() = default;
  virtual int64_t bytes() const = 0;
};

class World {
 public:
  virtual ~World() = default;

  /// Advances by dt. Throws RunError with sphere and step if the guard stops the run. On a GPU that may come to light in
  /// a later step, or in whatever asks for the state.
  virtual void step() = 0;

  /// Waits for all steps so far; throws as step() does.
  virtual void wait() {}

  /// Whether Report::stages is filled from now on, where that costs time.
  virtual void time_stages(bool) {}

  /// A copy of the present state and of the data of its detection. What a method does not have stays empty. Throws RunError
  /// if there are too many candidates to list.
  virtual Inspection inspect(const Wanted& wanted = {}) = 0;

  virtual Report report() = 0;

  /// From now on finds contacts by the broad phase, its parameters and the skin of these settings. The motion goes on, bit-identical
  /// unless a method misses contacts. Clears the times of the stages. False if the world has a detection of its own.
  virtual bool detect_by(const Settings&) { return false; }

  virtual BodyShape shape() const = 0;

  /// Writes the present state to memory that a vertex shader reads, and occluders if there is room for them.
  virtual void write_bodies(const BodyTarget& target) = 0;

  /// The present state in double precision.
  virtual Bodies bodies() = 0;

  /// The last state that passed the guard, and its time [s], for when step() has thrown.
  virtual Bodies last_good() { return bodies(); }
  virtual double last_good_time() { return time(); }

  /// Call between two steps: from now on it has these bodies, all that it had in their order, and perhaps new ones after
  /// them. Energy and overlap are guarded from this state on. Time, steps and tally go on.
  virtual void replace(const Bodies& bodies) = 0;

  /// A copy of everything that determines later states; for some worlds bodies() is not enough (docs/model.md).
  virtual std::unique_ptr<Snapshot> snapshot() = 0;

  /// Restores a state, also after step() has thrown. The run goes on bit-identically. Time spent stays counted.
  virtual void restore(const Snapshot& snapshot) = 0;

  virtual int64_t steps() const = 0;  ///< of this world
  virtual double time() const = 0;    ///< [s]

  /// Call before the first step: this world goes on from another one, which ended at this time [s] with this tally.
  virtual void go_on_from(double time, const Tally& tally) = 0;
};

/// A processor on which worlds run.
struct Backend {
  std::string name;                ///< "cpu"
  std::string unavailable_reason;  ///< empty if it is available
  std::string description;         ///< "NVIDIA H100, compute capability 9.0"
  std::unique_ptr<World> (*make_world)(const Scene&, const Settings&);
  std::unique_ptr<PairSearch> (*make_pair_search)(const Settings&);
};

Backend cpu_backend();
Backend cuda_backend();  ///< defined by the CUDA library, or by its stub

}  // namespace ballpit
