// SPDX-License-Identifier: MIT
#include "lecture/recorded_run.h"

#include <algorithm>

#include "broad_phase/parameters.h"
#include "broad_phase/sort_and_sweep.h"
#include "core/error.h"
#include "core/file.h"
#include "exec/cpu_executor.h"
#include "lecture/kernels/brute_force.h"
#include "lecture/kernels/sort_and_sweep.h"
#include "lecture_files.h"

namespace ballpit::lecture {

namespace {

/// The spheres of a run in the vector type of their scene.
template <class V>
struct Input {
  std::vector<V> position;
  std::vector<float> radius;
  Box<V> box;

  /// `distance` [m] moves all away from the origin, where floats are farther apart.
  Input(const BodySnapshot& bodies, const Domain& domain, double distance)
      : radius(bodies.radius),
        box{narrow<V>(domain.min + distance), narrow<V>(domain.max + distance), domain.boundary} {
    for (int64_t i = 0; i < bodies.count; ++i) {
      position.push_back(narrow<V>(Vec3d(bodies.position_of(i)) + distance));
    }
  }

  int count() const { return static_cast<int>(position.size()); }
  Spheres<V> spheres() const { return {{position.data(), count()}, {radius.data(), radius.size() == 1 ? 0 : 1}, box}; }
  BroadPhaseParameters<V> parameters(const Settings& settings) const {
    return broad_phase_parameters<V>(settings, box, {radius.data(), static_cast<int64_t>(radius.size())}, count());
  }
};

Span<int> span_of(std::vector<int>& values) { return {values.data(), static_cast<int64_t>(values.size())}; }

/// Runs phase after phase.
class Runner {
 public:
  explicit Runner(KernelName kernel) { run_.kernel = kernel; }

  RecordedMemory name(const char* array, std::vector<int>& values) {
    recorder_.name(array, span_of(values));
    return recorder_.memory();
  }

  template <class Kernel>
  void phase(std::string_view name, int64_t threads, const Kernel& kernel, const Interleaving& interleaving = {}) {
    const size_t first = recorder_.record().operations.size();
    recorder_.run(static_cast<int>(threads), kernel, interleaving);
    run_.phases.push_back({name, first, recorder_.record().operations.size()});
  }

  RecordedMemory memory() { return recorder_.memory(); }
  RecordedRun& run() { return run_; }

  RecordedRun finish() {
    run_.record = recorder_.take();
    for (const Operation& operation : run_.record.operations) {
      if (operation.action != Action::test) continue;
      ++run_.tests;
      const int i = static_cast<int>(operation.index), j = operation.other;
      if (operation.value != 0) run_.found.push_back({std::min(i, j), std::max(i, j)});
    }
    std::sort(run_.found.begin(), run_.found.end());
    return std::move(run_);
  }

 private:
  Recorder recorder_;
  RecordedRun run_;
};

template <class V>
RecordedRun run_brute_force(const Input<V>& input) {
  Runner runner(KernelName::brute_force);
  const BruteForce<V, RecordedMemory> kernels{runner.memory(), input.spheres(), {}};
  runner.phase("collide", input.count(), [&](int i) { kernels.collide(i); });
  return runner.finish();
}

template <class V>
RecordedRun run_sort_and_sweep(const Input<V>& input, const Settings& settings) {
  Runner runner(KernelName::sort_and_sweep);
  const BroadPhaseParameters<V> parameters = input.parameters(settings);
  const SweepRules<V> rules = sweep_rules(parameters);
  CpuExecutor exec(1);
  const int axis = parameters.axis != kAutoAxis
                       ? parameters.axis
                       : widest_axis(exec, input.spheres().position, (input.box.min + input.box.max) / Scalar<V>(2));
  runner.run().axis = axis;
  std::vector<int> list(2 * input.position.size(), kUnset);
  const SortAndSweep<V, RecordedMemory> kernels{
      runner.name("list", list), input.spheres(), {}, span_of(list), axis, rules.guard, rules.is_narrow[axis]};
  runner.phase("store", input.count(), [&](int i) { kernels.store_entries(i); });
  runner.phase("sort", 1, [&](int t) { kernels.sort(t); });
  runner.phase("sweep", 2 * int64_t(input.count()), [&](int t) { kernels.collide(t); });
  return runner.finish();
}

template <class V>
RecordedRun run_linked_cell(KernelName name, const Input<V>& input, const Input<V>& inserted, const Settings& settings,
                            const RunOptions& options) {
  Runner runner(name);
  const BroadPhaseParameters<V> parameters = input.parameters(settings);
  const Scalar<V> largest = parameters.largest_radius();
  const Grid<V> grid = make_grid(parameters, SizeClass<V>{largest, parameters.count}, V(2 * largest), false);
  GridInspection seen = describe_grid(grid);
  std::vector<Vec3> places;
  for (const V& p : inserted.position) {
    Vec3 place(0.0f);
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      place[axis] = float(p[axis] - grid.origin[axis]) * float(grid.inverse_edge[axis]);
    }
    places.push_back(place);
  }
  for (int axis = 0; axis < kDimensions<V>; ++axis) seen.origin[axis] -= static_cast<float>(options.distance);
  runner.run().grid = seen;
  runner.run().places = places;
  runner.run().truncates = options.mistakes.truncates;
  std::vector<int> head(static_cast<size_t>(grid.size()), kUnset), next(input.position.size(), kUnset);
  runner.name("head", head);
  const LinkedCell<V, RecordedMemory> kernels{
      runner.name("next", next), input.spheres(), {}, grid, span_of(head), span_of(next), options.mistakes};
  LinkedCell<V, RecordedMemory> inserting = kernels;
  inserting.spheres = inserted.spheres();
  runner.phase("clear", grid.size(), [&](int cell) { kernels.clear(cell); });
  const bool is_racing = name == KernelName::race;
  runner.phase(
      "insert", input.count(), [&](int i) { is_racing ? inserting.insert_racing(i) : inserting.insert(i); },
      options.interleaving);
  runner.phase("collide", input.count(), [&](int i) { kernels.collide(i); });
  return runner.finish();
}

template <class V>
RecordedRun run_kernel(KernelName kernel, const BodySnapshot& bodies, const Domain& domain, const Settings& settings,
                       const RunOptions& options) {
  const Input<V> input(bodies, domain, options.distance);
  switch (kernel) {
    case KernelName::brute_force:
      return run_brute_force(input);
    case KernelName::sort_and_sweep:
      return run_sort_and_sweep(input, settings);
    case KernelName::linked_cell:
    case KernelName::race:
      break;
  }
  if (options.inserted == nullptr) return run_linked_cell(kernel, input, input, settings, options);
  return run_linked_cell(kernel, input, Input<V>(*options.inserted, domain, options.distance), settings, options);
}

}  // namespace

const Phase& RecordedRun::phase_at(size_t cursor) const {
  for (const Phase& phase : phases) {
    if (cursor < phase.last) return phase;
  }
  return phases.back();
}

RecordedRun record_kernel(KernelName kernel, const BodySnapshot& bodies, const Domain& domain, const Settings& settings,
                          const RunOptions& options) {
  if (bodies.count > kMaxRecorded) {
    throw UserError("kernel", std::to_string(bodies.count) + " spheres", "at most " + std::to_string(kMaxRecorded));
  }
  if (domain.dimensions == 2) return run_kernel<Vec2>(kernel, bodies, domain, settings, options);
  return run_kernel<Vec3>(kernel, bodies, domain, settings, options);
}

std::vector<std::string_view> phases_of(KernelName kernel) {
  switch (kernel) {
    case KernelName::brute_force:
      return {"collide"};
    case KernelName::sort_and_sweep:
      return {"store", "sort", "sweep"};
    case KernelName::linked_cell:
    case KernelName::race:
      break;
  }
  return {"clear", "insert", "collide"};
}

std::string_view kernel_source(KernelName kernel) {
  const std::string_view name = kernel == KernelName::race ? name_of(KernelName::linked_cell) : name_of(kernel);
  std::string file(name);
  std::replace(file.begin(), file.end(), '-', '_');
  for (const EmbeddedFile& embedded : lecture_files()) {
    if (embedded.name == file + ".h") return embedded.text;
  }
  return {};
}

}  // namespace ballpit::lecture
