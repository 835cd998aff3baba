// SPDX-License-Identifier: MIT
// Overlapping pairs among spheres in arrays, without a world: what `ballpit pairs` and the benchmarks run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bodies/box.h"
#include "bodies/pair.h"
#include "core/math.h"
#include "core/span.h"
#include "exec/stage_times.h"

namespace ballpit {

/// Spheres at rest, in main memory, as their owner keeps them.
struct SphereArrays {
  Span<const Vec3> position;          ///< [m] finite
  Span<const float> radius;           ///< [m] above 0; one value for all, or one each
  std::optional<Box<Vec3>> period{};  ///< periodic domain that holds all centres, each edge four radii or longer
};

/// How a search was made, and what it took.
struct SearchReport {
  std::string method;         ///< the broad phase that searched: "sorted-grid", also where settings ask for auto
  std::string reason;         ///< why auto chose it; empty where it was asked for
  int64_t candidates = 0;     ///< narrow-phase tests made by the last search
  int64_t contacts = 0;       ///< pairs found by the last search
  int64_t searches = 0;       ///< times that the broad phase searched: in each find(), unless there is a skin
  int64_t bytes = 0;          ///< memory held, on the processor that searches
  std::vector<Stage> stages;  ///< time by stage, over all searches
};

class PairSearch {
 public:
  virtual ~PairSearch() = default;

  /// Finds all pairs: bounds, structure, tests, canonical order, everything from the arrays. With a skin, a search that
  /// follows one of as many spheres tests its candidate list again, as long as no sphere has moved half the skin.
  /// Throws UserError where the settings need more memory than an index reaches.
  virtual void find(const SphereArrays& spheres) = 0;

  /// The pairs of the last search, i < j, sorted by i, then j.
  virtual std::vector<Pair> pairs() = 0;

  virtual SearchReport report() = 0;

  /// What each thread of the last search walked, in the units of its method (candidates; list entries for the sweep):
  /// one number a thread, as a GPU would run it.
  virtual std::vector<int> work_per_thread() = 0;
};

}  // namespace ballpit
