// SPDX-License-Identifier: MIT
// Runs a slide's kernels on a few spheres and records all that they do, phase by phase. Pages of a lecture move a
// cursor over this record.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bodies/body_snapshot.h"
#include "bodies/pair.h"
#include "broad_phase/inspection.h"
#include "lecture/kernels/linked_cell.h"
#include "lecture/record.h"
#include "methods/settings.h"
#include "scene/scene.h"

namespace ballpit::lecture {

enum class KernelName { brute_force, sort_and_sweep, linked_cell, race };

}  // namespace ballpit::lecture

namespace ballpit {

template <>
inline constexpr auto kNames<lecture::KernelName> = in_order("brute-force", "sort-and-sweep", "linked-cell", "race");

}  // namespace ballpit

namespace ballpit::lecture {

inline constexpr int64_t kMaxRecorded = 500;  ///< spheres; more would make records that nobody steps through

/// Part of a record: a launch of one kernel function.
struct Phase {
  std::string_view name;       ///< "insert"
  size_t first = 0, last = 0;  ///< its operations: first … last − 1
};

struct RecordedRun {
  KernelName kernel;
  Record record;
  std::vector<Phase> phases;
  std::optional<GridInspection> grid;  ///< without lists
  std::vector<Vec3> places;  ///< linked cells: of the spheres when they were inserted, in cells from the origin
  bool truncates = false;    ///< Mistakes::truncates
  int axis = -1;             ///< of sort and sweep
  std::vector<Pair> found;   ///< in canonical order; a pair that was found twice comes twice
  int64_t tests = 0;

  /// The phase of the operation that follows the first `cursor` ones; the last phase at the end.
  const Phase& phase_at(size_t cursor) const;
};

/// How a kernel is run.
struct RunOptions {
  Interleaving interleaving{};             ///< of the phase that inserts particles
  Mistakes mistakes{};                     ///< of linked cells
  double distance = 0;                     ///< [m] of the spheres from the origin, along each axis, in single precision
  const BodySnapshot* inserted = nullptr;  ///< linked cells: the spheres as they are inserted, if they move afterwards
};

/// Runs a kernel. Throws UserError for more than kMaxRecorded spheres.
RecordedRun record_kernel(KernelName kernel, const BodySnapshot& bodies, const Domain& domain, const Settings& settings,
                          const RunOptions& options = {});

/// The names of a kernel's phases, in their order.
std::vector<std::string_view> phases_of(KernelName kernel);

/// The source text of a kernel's file, whose lines operations name.
std::string_view kernel_source(KernelName kernel);

}  // namespace ballpit::lecture
