// SPDX-License-Identifier: MIT
// A time step, whole. Data is pushed from stage to stage:
//
//     bodies ──▶ candidates ──▶ contacts ──▶ response ──▶ bodies          in each substep
//
// Where a kick or a drift belongs depends on the response; see the table in motion.h. An integrator that evaluates the
// forces more than once makes as many passes. Each stage's launches have names, by which timings list them.
#pragma once

#include "world/guard.h"
#include "world/motion.h"
#include "world/swept.h"
#include "world/tally_on.h"

namespace ballpit {

/// What a step works on.
template <class V, class Exec>
struct WorldParts {
  BodyStore<V, Exec> bodies;
  Collider<V, Exec> collider;
  std::unique_ptr<Motion<V, Exec>> motion;
  TallyKeeper<V, Exec> tally;
  Guard<V, Exec> guard;

  /// Call after changing positions.
  void moved() {
    bodies.wrap();
    collider.moved();
  }
};

/// Before the first step with these bodies, at `time` [s]: the references of the guard, and whether bodies overlap.
template <class V, class Exec>
void start(WorldParts<V, Exec>& world, double time, Scalar<V> h) {
  auto& [bodies, collider, motion, tally, guard] = world;
  const double elastic = motion->elastic_energy(bodies, collider.near_pairs(bodies.exec(), bodies.view()));
  guard.start(bodies, collider.near_pairs(bodies.exec(), bodies.view()), elastic, time, motion->kept());
  motion->start(bodies, guard.overlap_at_start(), h);
}

/// Sorts the bodies in memory by where they are, and all that is kept for each of them.
template <class V, class Exec>
void sort_bodies(WorldParts<V, Exec>& world) {
  world.bodies.sort([&](const auto& rearrange) {
    if (auto* const values = world.motion->kept()) rearrange(*values);
    for (auto* const values : world.tally.kept()) rearrange(*values);
    for (auto* const values : world.guard.kept()) rearrange(*values);
  });
  world.collider.discard();
}

/// Makes the step of this number, `substeps` parts of h [s] that end at `end` [s], after start(). Throws RunError if the guard
/// stops it.
template <class V, class Exec>
void make_step(WorldParts<V, Exec>& world, int64_t step, double end, int substeps, Scalar<V> h) {
  auto& [bodies, collider, motion, tally, guard] = world;
  Exec& exec = bodies.exec();
  if (bodies.order().is_due(step - 1)) sort_bodies(world);

  for (int substep = 0; substep < substeps; ++substep) {
    for (int pass = motion->first_pass(bodies); pass < motion->passes(); ++pass) {
      // Kick, drift
      if (motion->before_contacts(bodies, h, pass)) world.moved();

      // Broad phase, or the candidate list while it is fresh; then narrow phase
      ContactsView<V> contacts;
      if (SweptContacts<V, Exec>* const swept = motion->swept()) {
        contacts = swept->find(bodies, collider, h);
      } else {
        collider.find_candidates(exec, bodies.view(), motion->margin());
        contacts = collider.find_contacts(exec, bodies.view(), motion->contact_kind(exec));
      }

      // Respond
      const bool counts = motion->counts_collisions(pass);
      const ImpulseNotes<V> notes = tally.begin(exec, bodies.view(), bodies.box(), contacts.pairs.size(), counts);
      if (motion->respond(bodies, contacts, h, pass, notes)) world.moved();
      tally.end(exec, bodies.view(), bodies.box(), contacts.pairs, contacts.geometry, counts);

      // Kick, drift
      if (motion->after_contacts(bodies, h, pass)) world.moved();
    }
  }

  // Guard. Velocities are checked only where check() is due; a list that is fresh shows that positions are inside.
  const bool is_due = guard.is_due(step);
  if (is_due || !collider.shows_all_inside(exec, bodies.view())) guard.check_inside(bodies, step, end);
  if (is_due) guard.check(bodies, collider.near_pairs(exec, bodies.view()), step, end, motion->kept());
}

}  // namespace ballpit
