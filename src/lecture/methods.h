// SPDX-License-Identifier: MIT
// Broad phases that run the slides' own kernels. They test spheres themselves and yield pairs in contact. A comparison
// with the tuned methods shows what tuning gains. The interface is that of broad_phase/parameters.h, with
//
//     find(exec, bodies)       tests all candidates, after prepare(): the contacts, in any order
//     list_candidates(exec, bodies)
//                              the same without a test: the candidates
//     tests(exec)              the number of tests
//     work(exec)               the entries of lists that each thread has read, and the body that it works for, or −1
//
// in place of candidates().
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "broad_phase/sort_and_sweep.h"
#include "lecture/kernels/brute_force.h"
#include "lecture/kernels/linked_cell.h"
#include "lecture/kernels/sort_and_sweep.h"

namespace ballpit::lecture {

/// Whether a broad phase finds contacts itself.
template <class Method>
concept FindsPairs = std::remove_cvref_t<Method>::kFindsPairs;

/// Memory for kernels that list what they would test.
struct ListingMemory : AtomicMemory {
  HOST_DEVICE bool test(int, int, bool) const { return true; }
};

/// Kernels: a function of a slide's kernels, for each of its threads. (nvcc takes no pointers to member functions as
/// template arguments of kernels.)
template <class Kernels>
struct StoreEntries {
  Kernels kernels;
  HOST_DEVICE void operator()(int i) const { kernels.store_entries(i); }
};
template <class Kernels>
struct ClearCell {
  Kernels kernels;
  HOST_DEVICE void operator()(int cell) const { kernels.clear(cell); }
};
template <class Kernels>
struct InsertParticle {
  Kernels kernels;
  HOST_DEVICE void operator()(int i) const { kernels.insert(i); }
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
  HOST_DEVICE void operator()(int k) const { keys[k] = sortable(kernels.coordinate(kernels.list[k])); }
};

/// What the methods share: the memory of the pairs and of the threads' work. `Derived` has kernels<Memory>(bodies,
/// sink), whose collide(t) is the work of thread t of threads(bodies).
template <class Derived, class V, class Exec>
class Method {
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

 public:
  static constexpr bool kFindsPairs = true;

  Span<const Pair> find(Exec& exec, const BodiesView<V>& bodies) { return collide<AtomicMemory>(exec, bodies); }
  Span<const Pair> list_candidates(Exec& exec, const BodiesView<V>& bodies) {
    return collide<ListingMemory>(exec, bodies);
  }

  int64_t tests(Exec& exec) const {
    return reduce(exec, "sum tests", tests_.size(), int64_t{0}, ReadValue<int>{tests_.span()}, Sum{});
  }

  std::pair<std::vector<int>, std::vector<int>> work(Exec& exec) const {
    std::vector<int> worker(static_cast<size_t>(steps_.size()));
    std::iota(worker.begin(), worker.end(), 0);
    return {exec.download(steps_.span()), worker};
  }

  std::vector<GridInspection> inspect(Exec&) const { return {}; }
  int64_t bytes() const { return pairs_.bytes() + count_.bytes() + tests_.bytes() + steps_.bytes(); }

 protected:
  Spheres<V> spheres(const BodiesView<V>& bodies) const { return {bodies.position, bodies.radius, box_}; }

  Box<V> box_;

 private:
  /// Runs again where the pairs did not fit.
  template <class Memory>
  Span<const Pair> collide(Exec& exec, const BodiesView<V>& bodies) {
    auto& self = static_cast<Derived&>(*this);
    tests_.resize(self.threads(bodies));
    steps_.resize(self.threads(bodies));
    count_.resize(1);
    for (;;) {
      exec.fill("clear count", count_.span(), 0ull);
      const auto kernels = self.template kernels<Memory>(bodies, PairSink{pairs_.span(), count_.span().data()});
      exec.parallel_for(Derived::kCollide, tests_.size(),
                        Collide<std::remove_const_t<decltype(kernels)>>{kernels, tests_.span(), steps_.span()});
      const auto found = static_cast<int64_t>(exec.download(count_.span())[0]);
      if (found <= pairs_.size()) return {pairs_.span().data(), found};
      pairs_.resize(found);
    }
  }

  Buffer<Pair> pairs_;
  Buffer<unsigned long long> count_;
  Buffer<int> tests_, steps_;
};

template <class V, class Exec>
class BruteForceMethod : public Method<BruteForceMethod<V, Exec>, V, Exec> {
 public:
  static constexpr const char* kCollide = "slide 5: test all";

  explicit BruteForceMethod(const BroadPhaseParameters<V>& parameters) { plan(parameters); }
  void plan(const BroadPhaseParameters<V>& parameters) { this->box_ = parameters.box; }
  void prepare(Exec&, const BodiesView<V>&) {}

  int64_t threads(const BodiesView<V>& bodies) const { return bodies.size(); }
  template <class Memory>
  BruteForce<V, Memory> kernels(const BodiesView<V>& bodies, const PairSink& sink) {
    return {{}, this->spheres(bodies), sink};
  }
};

template <class V, class Exec>
class SortAndSweepMethod : public Method<SortAndSweepMethod<V, Exec>, V, Exec> {
  using Base = Method<SortAndSweepMethod<V, Exec>, V, Exec>;

 public:
  static constexpr const char* kCollide = "slide 4: sweep";

  explicit SortAndSweepMethod(const BroadPhaseParameters<V>& parameters) { plan(parameters); }

  void plan(const BroadPhaseParameters<V>& parameters) {
    this->box_ = parameters.box;
    rules_ = sweep_rules(parameters);
    wanted_axis_ = parameters.axis;
  }

  void prepare(Exec& exec, const BodiesView<V>& bodies) {
    const int64_t n = bodies.size();
    const V center = (this->box_.min + this->box_.max) / Scalar<V>(2);
    axis_ = wanted_axis_ >= 0 ? wanted_axis_ : widest_axis(exec, bodies.position, center);
    list_.resize(2 * n);
    keys_.resize(2 * n);
    const auto kernels = this->kernels<AtomicMemory>(bodies, {});
    using Kernels = SortAndSweep<V, AtomicMemory>;
    exec.parallel_for("slide 2: store entries", n, StoreEntries<Kernels>{kernels});
    exec.parallel_for("slide 2: project", 2 * n, StoreKeys<Kernels>{kernels, keys_.span()});
    exec.sort_pairs("slide 3: sort", keys_.span(), list_.span());
  }

  int64_t threads(const BodiesView<V>& bodies) const { return 2 * bodies.size(); }
  template <class Memory>
  SortAndSweep<V, Memory> kernels(const BodiesView<V>& bodies, const PairSink& sink) {
    return {{}, this->spheres(bodies), sink, list_.span(), axis_, rules_.guard, rules_.is_narrow[axis_]};
  }

  /// One thread per entry: those of the ends are idle.
  std::pair<std::vector<int>, std::vector<int>> work(Exec& exec) const {
    auto [steps, worker] = Base::work(exec);
    const std::vector<int> list = exec.download(list_.span());
    for (size_t k = 0; k < list.size(); ++k) worker[k] = list[k] % 2 == 0 ? list[k] / 2 : -1;
    return {steps, worker};
  }

  int axis() const { return axis_; }

  /// The sorted list, for the bodies that it was prepared for.
  std::vector<Endpoint> endpoints(Exec& exec, const BodiesView<V>& bodies) const {
    const bool is_uniform = bodies.radius.is_uniform() && bodies.size() > 0;
    const std::vector<V> position = exec.download(bodies.position);
    const auto radius = exec.download(Span<const Scalar<V>>(bodies.radius.data(), is_uniform ? 1 : bodies.size()));
    std::vector<int> list = exec.download(list_.span());
    const Spheres<V> spheres{{position.data(), bodies.size()}, {radius.data(), is_uniform ? 0 : 1}, this->box_};
    const SortAndSweep<V, PlainMemory> kernels{{}, spheres, {}, {}, axis_, rules_.guard, false};
    std::vector<Endpoint> result;
    for (const int entry : list) {
      result.push_back({kernels.coordinate(entry), kernels.sphere_of(entry), kernels.is_end(entry)});
    }
    return result;
  }

  int64_t bytes() const { return Base::bytes() + list_.bytes() + keys_.bytes(); }

 private:
  SweepRules<V> rules_;
  int wanted_axis_ = kAutoAxis;
  int axis_ = 0;
  typename Exec::template Buffer<int> list_;
  typename Exec::template Buffer<uint32_t> keys_;
};

template <class V, class Exec>
class LinkedCellMethod : public Method<LinkedCellMethod<V, Exec>, V, Exec> {
  using Base = Method<LinkedCellMethod<V, Exec>, V, Exec>;

 public:
  static constexpr const char* kCollide = "slide 10: walk cells";

  explicit LinkedCellMethod(const BroadPhaseParameters<V>& parameters) { plan(parameters); }

  void plan(const BroadPhaseParameters<V>& parameters) {
    this->box_ = parameters.box;
    const Scalar<V> largest = parameters.largest_radius();
    grid_ = make_grid(parameters, SizeClass<V>{largest, parameters.count}, V(2 * largest), false);
  }

  void prepare(Exec& exec, const BodiesView<V>& bodies) {
    head_.resize(grid_.size());
    next_.resize(bodies.size());
    const auto kernels = this->kernels<AtomicMemory>(bodies, {});
    using Kernels = LinkedCell<V, AtomicMemory>;
    exec.parallel_for("slide 13: clear cells", head_.size(), ClearCell<Kernels>{kernels});
    exec.parallel_for("slide 14: insert", bodies.size(), InsertParticle<Kernels>{kernels});
  }

  int64_t threads(const BodiesView<V>& bodies) const { return bodies.size(); }
  template <class Memory>
  LinkedCell<V, Memory> kernels(const BodiesView<V>& bodies, const PairSink& sink) {
    return {{}, this->spheres(bodies), sink, grid_, head_.span(), next_.span(), {}};
  }

  std::vector<GridInspection> inspect(Exec& exec) const {
    GridInspection result = describe_grid(grid_);
    result.head = exec.download(head_.span());
    result.next = exec.download(next_.span());
    return {result};
  }

  int64_t bytes() const { return Base::bytes() + head_.bytes() + next_.bytes(); }

 private:
  Grid<V> grid_;
  typename Exec::template Buffer<int> head_, next_;
};

}  // namespace ballpit::lecture
