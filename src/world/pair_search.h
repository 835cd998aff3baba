// SPDX-License-Identifier: MIT
// Finds overlapping pairs among spheres in arrays, without a world, for `ballpit pairs` and the benchmarks.
#pragma once

#include "bodies/box.h"
#include "bodies/pair.h"
#include "core/span.h"
#include "exec/stage_times.h"

namespace ballpit {

/// Spheres at rest, in main memory.
struct SphereArrays {
  Span<const Vec3> position;          ///< [m] finite
  Span<const float> radius;           ///< [m] above 0; one value for all, or one each
  std::optional<Box<Vec3>> period{};  ///< periodic domain that holds all centres, each edge four radii or longer
};

/// How a search was made, and what it took.
struct SearchReport {
  std::string method;         ///< the broad phase that searched: "sorted-grid"; never auto
  std::string reason;         ///< why auto chose it, or empty
  int64_t candidates = 0;     ///< pairs tested by the last search
  int64_t contacts = 0;       ///< pairs found by the last search
  int64_t searches = 0;       ///< by the broad phase: one in each find(), unless there is a skin
  int64_t bytes = 0;          ///< memory held, on the processor that searches
  std::vector<Stage> stages;  ///< time by stage, over all searches
};

class PairSearch {
 public:
  virtual ~PairSearch() = default;

  /// Finds all pairs. With a skin, a search of the same number of spheres tests its candidate list again, as long as no
  /// sphere has left its skin. Throws UserError if the settings need more memory than an index can address.
  virtual void find(const SphereArrays& spheres) = 0;

  /// The pairs of the last search, i < j, sorted by i, then j.
  virtual std::vector<Pair> pairs() = 0;

  virtual SearchReport report() = 0;

  /// The work of each thread of the last search, as a GPU would run it: candidates, or list entries for the slides'
  /// kernels.
  virtual std::vector<int> work_per_thread() = 0;
};

}  // namespace ballpit
