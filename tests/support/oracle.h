// SPDX-License-Identifier: MIT
// Pairs in contact by definition, written independently of the simulation: the reference for every search. For many spheres
// tests use the other independent reference, measure/exact_pairs.h, which is checked against this one.
#pragma once

#include <string>
#include <vector>

#include "bodies/body_snapshot.h"
#include "bodies/pair.h"
#include "families.h"
#include "scene/scene.h"
#include "world/pair_search.h"

namespace ballpit {

/// All pairs of a scene, tested in the simulation's own precision, one by one: O(n²).
std::vector<Pair> pairs_by_definition(const Scene& scene);

/// The same for a simulation in double precision.
std::vector<Pair> pairs_by_definition_in_double(const Scene& scene);

/// What `found` lacks of `expected`, has beyond it, or has in another order; empty where they are equal.
std::string difference(const std::vector<Pair>& found, const std::vector<Pair>& expected);

/// A scene of the same spheres, in a box around their centres.
Scene scene_of(const Spheres& spheres, int dimensions = 3);

/// The spheres of a scene, rounded as a world rounds them; one radius each, or one where all are equal.
Spheres spheres_of(const Scene& scene);

/// Views of spheres that live on.
inline SphereArrays arrays_of(const Spheres& spheres) {
  return {{spheres.position.data(), spheres.count()},
          {spheres.radius.data(), static_cast<int64_t>(spheres.radius.size())}};
}

/// The occluders of all spheres, by the definition in world/occluders.h, with every pair looked at.
std::vector<Occluders> all_occluders(const BodySnapshot& bodies);

}  // namespace ballpit
