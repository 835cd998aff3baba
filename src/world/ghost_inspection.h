// SPDX-License-Identifier: MIT
// What overlays and panel show of a ghost: exact motion beside a stepped world (world/ghost.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/math.h"

namespace ballpit {

/// How a collision of the stepped world compares with the same one in exact motion. `open`: it has not come yet.
enum class Timing { open, late, early, missed };

/// The first collision, by its exact time, that the stepped world has in another step, or not at all.
struct WrongCollision {
  Timing timing = Timing::open;
  double time = 0;                  ///< [s] in exact motion
  double late_by = 0;               ///< [s] negative: early; 0 for one that is missed
  int32_t body = -1, partner = -1;  ///< no partner: a wall
  Vec3 place{0.0f};                 ///< [m] where the surfaces touch in exact motion
};

/// The distances of all spheres from where exact motion has them, in units of their own radii.
struct GhostDistance {
  double time = 0;  ///< [s]
  double median = 0, largest = 0;
};

struct GhostInspection {
  std::string_view lack;             ///< why exact motion cannot serve at this moment; empty if it can
  double dropped = 0;                ///< [s] when exact motion began from the stepped state
  double overlap = 0;                ///< the largest of that state, in smaller radii; exact motion has none
  bool is_exact = false;             ///< the world beside it moves by events too
  std::vector<Vec3> ahead;           ///< [m] from each sphere to its ghost, the nearest image; empty if there is a lack
  std::vector<GhostDistance> curve;  ///< up to the present moment
  std::optional<WrongCollision> wrong;
  bool is_unwatched = false;  ///< steps were left out, so the first wrong collision is not known
  double growth = 0;          ///< [1/s] Lyapunov's exponent of this gas; 0 if it is unknown
  double growth_from = 0;     ///< [s] when each sphere had collided once, on average
};

}  // namespace ballpit
