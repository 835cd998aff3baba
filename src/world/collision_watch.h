// SPDX-License-Identifier: MIT
// Finds the first collision that a stepped world has late, early or not at all, by comparing it with exact motion.
//
//     exact      ───────────╲τ                at time τ the velocity changes by Δv
//     stepped    ───────────────╲             the step in which half of Δv is reached is that of its collision
//                │  step k  │ step k+1 │
//
//     on time    in the step that contains τ
//     late       in a later step           late by t − τ
//     early      in an earlier step        early by τ − t
//     missed     the spheres part without it: they have passed each other, or never met
//
// t is the moment in the stepped world's step at which a sudden change of the velocity explains the position at the end
// of the step. So impulses at the begin of a step are dated there. Springs take the time of a contact, and count at
// half of Δv.
//
// Collisions are judged in the order of their exact times; the first wrong one ends the search, since all later ones
// follow from it. Not judged are those that change a velocity by less than a hundredth of the mean speed, or by less
// than gravity does in four steps: grazing ones, and those of spheres at rest. Cost: O(n) a step.
#pragma once

#include <optional>
#include <vector>

#include "event_driven/event_driven.h"
#include "world/exact_motion.h"
#include "world/ghost_inspection.h"

namespace ballpit {

class CollisionWatch {
 public:
  /// Both motions begin with these bodies.
  CollisionWatch(const Bodies& start, const Vec3d& gravity);

  /// A step of `dt` [s] that ends at `time` [s]: the stepped world's bodies and their lead at its end, and the exact
  /// collisions in it. Afterwards `lead` holds something else.
  void step(double time, double dt, const Bodies& stepped, const ExactMotion& exact, Lead& lead,
            std::vector<LoggedCollision> collisions);

  /// Whether the search goes on: a wrong collision may still be late or missed.
  bool is_searching() const { return !found_ || found_->timing == Timing::open; }

  const std::optional<WrongCollision>& found() const { return found_; }

 private:
  /// Whose change of velocity shows a collision: the faster changed sphere of a pair.
  struct Judged {
    size_t body;
    Vec3d change;  // [m/s] in exact motion
  };

  /// A collision that has not come by the end of its step.
  struct Missing {
    LoggedCollision collision;
    Judged judged;
    Vec3d velocity;  // [m/s] in the stepped world before the step
    double time;     // [s] of that velocity
  };

  static Judged judged(const LoggedCollision& collision);
  void judge(double time, double dt, std::vector<LoggedCollision> collisions);
  void follow(double time, double dt, const Bodies& stepped, const ExactMotion& exact);
  bool has_parted(const Bodies& stepped, const ExactMotion& exact) const;
  double moment_of_jump(size_t i, double time, double dt) const;
  void find(const LoggedCollision& collision, Timing timing, double late_by);

  Vec3d gravity_;                         // [m/s²]
  std::vector<Vec3d> stepped_velocity_;   // [m/s] before the step
  Lead before_, now_;                     // before the step and after it
  std::vector<double> jumped_;            // [s] when a sphere's lead last changed suddenly
  std::vector<LoggedCollision> carried_;  // so close to the end of the step that rounding decides on their step
  double slight_ = 0;                     // [m/s] smaller changes of a velocity are not judged
  std::optional<Missing> missing_;
  std::optional<WrongCollision> found_;
};

}  // namespace ballpit
