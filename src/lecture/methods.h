// SPDX-License-Identifier: MIT
// Broad phases that run the slides' own kernels. They test spheres themselves and yield pairs in contact. A comparison with
// the tuned methods shows what tuning gains. The interface is that of broad_phase/parameters.h, with
//
//     find(exec, bodies)       tests all candidates, after prepare(); found() are the contacts, in any order
//     tests(exec)              the number of tests
//     work(exec)               the entries of lists that each thread has read
//
// in place of candidates().
#pragma once

#include <vector>

#include "broad_phase/sort_and_sweep.h"
#include "broad_phase/sweep_rules.h"
#include "exec/reduce.h"
#include "lecture/brute_force.h"
#include "lecture/linked_cell.h"
#include "lecture/sort_and_sweep.h"

namespace ballpit::lecture {

/// Kernel: a member function of a slide's kernels, for thread t.
template <class Kernels, auto kFunction>
struct Run {
  Kernels kernels;
  HOST_DEVICE void operator()(int t) const { (kernels.*kFunction)(t); }
};

/// Kernel: tests the candidates of thread t and notes its work.
template <class Kernels>
struct Collide {
  Kernels kernels;
  Span<int> tests, steps;
  HOST_DEVICE void operator()(int t) const {
    const Work work = kernels.collide(t);
    tests[t] = work.tests;
    steps[t] = work.steps;
  }
};

/// Kernel: the keys by which the list of sort and sweep is sorted.
template <class Kernels>
struct StoreKeys {
  Kernels kernels;
  Span<uint32_t> keys;
  HOST_DEVICE void operator()(int entry) const { keys[entry] = sortable(kernels.coordinate(entry)); }
};

/// Kernel: the position of entry k of the sorted list.
template <class Kernels>
struct LocateEntry {
  Kernels kernels;
  Span<float> at;  ///< [m]
  HOST_DEVICE void operator()(int k) const { at[k] = kernels.coordinate(kernels.list[k]); }
};

/// What the methods share: the memory of the pairs and of the threads' work.
template <class V, class Exec>
class Method {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  void plan(const BroadPhaseParameters<V>& parameters) { box_ = parameters.box; }

  Span<const Pair> found() const { return {pairs_.span().data(), found_}; }
  int64_t tests(Exec& exec) const {
    return reduce(exec, "sum tests", tests_.size(), int64_t{0}, ReadValue<int>{tests_.span()}, Sum{});
  }
  std::vector<int> work(Exec& exec) const { return exec.download(Span<const int>(steps_.span())); }
  std::vector<GridInspection> inspect(Exec&) const { return {}; }
  int64_t bytes() const { return pairs_.bytes() + count_.bytes() + tests_.bytes() + steps_.bytes(); }

 protected:
  Spheres<V> spheres(const BodiesView<V>& bodies) const { return {bodies.position, bodies.radius, box_}; }

  /// Runs the kernel that `kernels_into(sink)` makes; again where the contacts did not fit.
  template <class KernelsInto>
  void collide(Exec& exec, const char* name, int64_t threads, const KernelsInto& kernels_into) {
    tests_.resize(threads);
    steps_.resize(threads);
    count_.resize(1);
    for (;;) {
      exec.fill("clear count", count_.span(), 0ull);
      const auto kernels = kernels_into(PairSink{pairs_.span(), count_.span().data()});
      exec.parallel_for(name, threads, Collide<decltype(kernels)>{kernels, tests_.span(), steps_.span()});
      found_ = static_cast<int64_t>(exec.download(count_.span())[0]);
      if (found_ <= pairs_.size()) return;
      pairs_.resize(found_);
    }
  }

 private:
  Box<V> box_;
  Buffer<Pair> pairs_;
  Buffer<unsigned long long> count_;
  Buffer<int> tests_, steps_;
  int64_t found_ = 0;
};

template <class V, class Exec>
class BruteForceMethod : public Method<V, Exec> {
 public:
  explicit BruteForceMethod(const BroadPhaseParameters<V>& parameters) { this->plan(parameters); }

  void prepare(Exec&, const BodiesView<V>&) {}

  void find(Exec& exec, const BodiesView<V>& bodies) {
    this->collide(exec, "slide 5: test all", bodies.size(), [&](const PairSink& sink) {
      return BruteForce<V, AtomicMemory>{{}, this->spheres(bodies), sink};
    });
  }
};

template <class V, class Exec>
class SortAndSweepMethod : public Method<V, Exec> {
 public:
  explicit SortAndSweepMethod(const BroadPhaseParameters<V>& parameters) { plan(parameters); }

  void plan(const BroadPhaseParameters<V>& parameters) {
    Method<V, Exec>::plan(parameters);
    rules_ = sweep_rules(parameters);
    wanted_axis_ = parameters.axis;
  }

  void prepare(Exec& exec, const BodiesView<V>& bodies) {
    const int64_t n = bodies.size();
    const Box<V>& box = this->spheres(bodies).box;
    axis_ = wanted_axis_ >= 0 ? wanted_axis_ : widest_axis(exec, bodies.position, (box.min + box.max) / Scalar<V>(2));
    list_.resize(2 * n);
    keys_.resize(2 * n);
    const Kernels kernels = this->kernels(bodies, {});
    exec.parallel_for("slide 2: store entries", n, Run<Kernels, &Kernels::store_entries>{kernels});
    exec.parallel_for("slide 2: project", 2 * n, StoreKeys<Kernels>{kernels, keys_.span()});
    exec.sort_pairs("slide 3: sort", keys_.span(), list_.span());
  }

  void find(Exec& exec, const BodiesView<V>& bodies) {
    this->collide(exec, "slide 4: sweep", list_.size(), [&](const PairSink& sink) { return kernels(bodies, sink); });
  }

  int axis() const { return axis_; }

  /// The sorted list, for the bodies that it was prepared for.
  std::vector<Endpoint> endpoints(Exec& exec, const BodiesView<V>& bodies) const {
    typename Exec::template Buffer<float> positions;
    positions.resize(list_.size());
    exec.parallel_for("locate entries", positions.size(), LocateEntry<Kernels>{kernels(bodies, {}), positions.span()});
    const std::vector<int> list = exec.download(Span<const int>(list_.span()));
    const std::vector<float> at = exec.download(positions.span());
    std::vector<Endpoint> result;
    for (size_t k = 0; k < at.size(); ++k) {
      result.push_back({at[k], Kernels::sphere_of(list[k]), Kernels::is_end(list[k])});
    }
    return result;
  }

  int64_t bytes() const { return Method<V, Exec>::bytes() + list_.bytes() + keys_.bytes(); }

 private:
  using Kernels = SortAndSweep<V, AtomicMemory>;

  Kernels kernels(const BodiesView<V>& bodies, const PairSink& sink) const {
    const Span<const int> list = list_.span();
    return {{}, this->spheres(bodies), sink, {const_cast<int*>(list.data()), list.size()}, axis_, rules_.guard,
            rules_.is_narrow[axis_]};
  }

  SweepRules<V> rules_;
  int wanted_axis_ = kAutoAxis;
  int axis_ = 0;
  typename Exec::template Buffer<int> list_;
  typename Exec::template Buffer<uint32_t> keys_;
};

template <class V, class Exec>
class LinkedCellMethod : public Method<V, Exec> {
 public:
  explicit LinkedCellMethod(const BroadPhaseParameters<V>& parameters) { plan(parameters); }

  void plan(const BroadPhaseParameters<V>& parameters) {
    Method<V, Exec>::plan(parameters);
    const Scalar<V> largest = parameters.largest_radius();
    grid_ = make_grid(parameters, SizeClass<V>{largest, parameters.count}, V(2 * largest), false);
  }

  void prepare(Exec& exec, const BodiesView<V>& bodies) {
    head_.resize(grid_.size());
    next_.resize(bodies.size());
    const Kernels kernels = this->kernels(bodies, {});
    exec.parallel_for("slide 13: clear cells", head_.size(), Run<Kernels, &Kernels::clear>{kernels});
    exec.parallel_for("slide 14: insert", bodies.size(), Run<Kernels, &Kernels::insert>{kernels});
  }

  void find(Exec& exec, const BodiesView<V>& bodies) {
    this->collide(exec, "slide 10: walk cells", bodies.size(),
                  [&](const PairSink& sink) { return kernels(bodies, sink); });
  }

  std::vector<GridInspection> inspect(Exec& exec) const {
    GridInspection result = describe_grid(grid_);
    result.head = exec.download(Span<const int>(head_.span()));
    result.next = exec.download(Span<const int>(next_.span()));
    return {result};
  }

  int64_t bytes() const { return Method<V, Exec>::bytes() + head_.bytes() + next_.bytes(); }

 private:
  using Kernels = LinkedCell<V, AtomicMemory>;

  Kernels kernels(const BodiesView<V>& bodies, const PairSink& sink) {
    return {{}, this->spheres(bodies), sink, grid_, head_.span(), next_.span(), {}};
  }

  Grid<V> grid_;
  typename Exec::template Buffer<int> head_, next_;
};

}  // namespace ballpit::lecture
