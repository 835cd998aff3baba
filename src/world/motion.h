// SPDX-License-Identifier: MIT
// What a response does in a substep, before and after the contacts are found. step.h calls these functions in their order:
//
//                    before_contacts()     contacts              respond()               after_contacts()
//     velocities     –                     touching              kick, impulses          drift             velocity_motion.h
//     swept          –                     met on the way        impulses, then drift    –                 velocity_motion.h
//     forces         –, or kick, drift     candidates            forces                  kick, drift       force_motion.h
//     positions      kick, drift           touching and near     push apart, rebound     –                 position_motion.h
//
// An integrator of forces may need several passes. Each response is compiled by itself.
#pragma once

#include "bodies/tally.h"
#include "narrow_phase/collider.h"
#include "world/body_store.h"

namespace ballpit {

template <class V, class Exec>
class SweptContacts;

template <class V, class Exec>
class Motion {
 public:
  using Real = Scalar<V>;

  /// What a snapshot holds of a motion.
  struct Saved {
    std::vector<V> acceleration;      // of the substep before
    int64_t substeps = 0;             // since the start
    bool starts_overlapping = false;  // of position-based
  };

  virtual ~Motion() = default;

  /// Called before the first step. `overlap` is the largest at the start, a fraction of the smaller radius; h [s].
  virtual void start(BodyStore<V, Exec>&, double /*overlap*/, Real /*h*/) {}

  /// The pairs that respond() takes.
  virtual ContactKind contact_kind(const Exec&) const { return ContactKind::touching; }

  /// [m] Spheres within this distance count as touching.
  virtual Real margin() const { return 0; }

  /// Finds contacts along the paths of the bodies; null where contacts are those of the present positions.
  virtual SweptContacts<V, Exec>* swept() { return nullptr; }

  /// Passes of the next substep: first_pass() … passes() − 1.
  virtual int first_pass(const BodyStore<V, Exec>&) const { return 0; }
  virtual int passes() const { return 1; }

  /// Whether contacts that are new in this pass count as collisions.
  virtual bool counts_collisions(int /*pass*/) const { return true; }

  // Each returns whether it has changed positions. h [s] is the length of a substep.
  virtual bool before_contacts(BodyStore<V, Exec>&, Real /*h*/, int /*pass*/) { return false; }
  virtual bool respond(BodyStore<V, Exec>& bodies, const ContactsView<V>& contacts, Real h, int pass,
                       const ImpulseNotes<V>& notes) = 0;
  virtual bool after_contacts(BodyStore<V, Exec>&, Real /*h*/, int /*pass*/) { return false; }

  /// Whether a step follows from positions, velocities, kept() and substeps() alone, and its kernels go by
  /// ContactsView::count().
  virtual bool can_repeat() const { return false; }

  /// Substeps since the start, where the next one depends on them.
  virtual int64_t substeps() const { return 0; }
  virtual void go_back(int64_t /*substeps*/) {}

  /// [J] in springs; `pairs` include all contacts.
  virtual double elastic_energy(const BodyStore<V, Exec>&, Span<const Pair> /*pairs*/) const { return 0; }

  /// What it keeps for each body from substep to substep, by slot; or null.
  virtual typename Exec::template Buffer<V>* kept() { return nullptr; }

  virtual Saved save(Exec&) { return {}; }
  virtual void restore(Exec&, const Saved&) {}

  virtual int64_t bytes() const = 0;
};

// Defined in the header named after the kind of motion.
template <class V, class Exec>
std::unique_ptr<Motion<V, Exec>> make_kinematic_motion(const Scene& scene, const Settings& settings);
template <class V, class Exec>
std::unique_ptr<Motion<V, Exec>> make_impulse_motion(const Scene& scene, const Settings& settings);
template <class V, class Exec>
std::unique_ptr<Motion<V, Exec>> make_penalty_motion(const Scene& scene, const Settings& settings);
template <class V, class Exec>
std::unique_ptr<Motion<V, Exec>> make_position_based_motion(const Scene& scene, const Settings& settings);

template <class V, class Exec>
std::unique_ptr<Motion<V, Exec>> make_motion(const Scene& scene, const Settings& settings) {
  if (settings.response == Response::kinematic) return make_kinematic_motion<V, Exec>(scene, settings);
  if (settings.response == Response::impulse) return make_impulse_motion<V, Exec>(scene, settings);
  if (settings.response == Response::penalty) return make_penalty_motion<V, Exec>(scene, settings);
  if (settings.response == Response::position_based) return make_position_based_motion<V, Exec>(scene, settings);
  throw std::logic_error("the event-driven response has a world of its own");
}

}  // namespace ballpit
