// SPDX-License-Identifier: MIT
// Detection, whole: a broad phase, the narrow phase that fits its candidates, and a candidate list where there is a skin.
//
//     bodies ──▶ list valid? ──yes──▶ test the list ────────────────────────────┐
//                    │ no, or no skin                                            ├──▶ contacts in canonical order
//                    └──▶ broad phase ──▶ lists or ranges ──▶ tests ──▶ rows ───┘
//
// What is found does not depend on the way: neither contacts nor their order.
#pragma once

#include <numeric>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "bodies/pair.h"
#include "broad_phase/brute_force.h"
#include "broad_phase/inspection.h"
#include "broad_phase/linked_cell.h"
#include "broad_phase/sort_and_sweep.h"
#include "broad_phase/sorted_grid.h"
#include "core/span.h"
#include "methods/settings.h"
#include "narrow_phase/candidate_pairs.h"
#include "narrow_phase/filter_list.h"
#include "narrow_phase/list_search.h"
#include "narrow_phase/range_search.h"
#include "world/inspection.h"

namespace ballpit {

/// Kernel: how many slots thread t looks at.
template <class Candidates>
struct MeasureRanges {
  Candidates candidates;
  Span<int> work;

  HOST_DEVICE void operator()(int t) const {
    int sum = 0;
    const int slot = candidates.slot_of(t);
    if (slot >= 0) candidates.for_each_range(slot, [&](const SlotRange& range) { sum += range.size(); });
    work[t] = sum;
  }
};

/// See Detector::near_pairs().
struct NearPairs {
  Span<const Pair> pairs;
  Span<const int> first;  ///< where each body's row begins
  int64_t version;        ///< other pairs have another
  bool are_contacts;      ///< and nothing else
};

/// Kernel: the body that thread t walks for, or −1.
template <class Candidates>
struct NameWorker {
  Candidates candidates;
  Span<int> worker;

  HOST_DEVICE void operator()(int t) const {
    const int slot = candidates.slot_of(t);
    worker[t] = slot >= 0 ? candidates.slots().body[slot] : -1;
  }
};

template <class V, class Exec>
class Detector {
  using BroadPhase = std::variant<BruteForce<V, Exec>, SortAndSweep<V, Exec>, LinkedCell<V, Exec>, SortedGrid<V, Exec>>;

 public:
  Detector() = default;  ///< to be planned
  Detector(ballpit::BroadPhase method, const BroadPhaseParameters<V>& parameters, double skin) {
    plan(method, parameters, skin);
  }

  /// Starts anew, in the memory held. `method` is no longer automatic; `parameters` are those of the
  /// bodies without skins.
  void plan(ballpit::BroadPhase method, BroadPhaseParameters<V> parameters, double skin);

  /// Finds all contacts among the bodies.
  void find(Exec& exec, const BodiesView<V>& bodies);

  /// Pairs among which all contacts are, in canonical order: the candidate list while it is good, else the contacts. Those
  /// who test pairs anyway save a pass by it.
  NearPairs near_pairs(Exec& exec, const BodiesView<V>& bodies);

  /// What find() found, as near pairs.
  NearPairs contacts() const { return {rows_.pairs(), rows_.first(), searches_, true}; }

  /// To be called by whoever has moved the bodies, before anything is found among them.
  void moved() { list_.moved(); }

  /// Whether the candidate list shows that all bodies are inside the domain and finite, so that nobody else need look. The
  /// next to ask for contacts has the list checked already.
  bool shows_all_inside(Exec& exec, const BodiesView<V>& bodies);

  /// Whether the last contacts or near pairs came from a candidate list.
  bool has_used_list() const { return is_list_last_; }

  /// Forgets the candidate list: the bodies are others now.
  void discard() {
    list_.discard();
    list_uses_ = kWorthwhile;
  }

  Span<const Pair> pairs() const { return rows_.pairs(); }  ///< in canonical order
  Span<const int> first() const { return rows_.first(); }   ///< where each body's row begins

  /// Narrow-phase tests made by the last find(), without those that made the candidate list.
  int64_t candidates(Exec& exec) const;

  /// How often the broad phase has searched since the last plan.
  int64_t searches() const { return searches_; }

  /// The broad phase's grids for these positions; they are built where the candidate list has passed over them.
  std::vector<GridInspection> inspect(Exec& exec, const BodiesView<V>& bodies);

  /// The pairs that the last search of these bodies gave to the narrow phase, in contact or not, in canonical order.
  std::vector<Pair> candidate_pairs(Exec& exec, const BodiesView<V>& bodies) const;

  /// The axis and the sorted list of the last search of these bodies, where it was by sort-and-sweep.
  void inspect_sweep(Exec& exec, const BodiesView<V>& bodies, Inspection& seen) const;

  /// What each thread of the last search walked.
  std::vector<int> work_per_thread(Exec& exec) const;

  /// The body that each thread of the last search walked for, or −1.
  std::vector<int> body_per_thread(Exec& exec) const;

  int64_t bytes() const;

 private:
  /// Whether there is a candidate list that is good for these positions; one is made where it is due.
  bool has_list(Exec& exec, const BodiesView<V>& bodies);

  template <class Method>
  void use(const BroadPhaseParameters<V>& parameters) {
    if (auto* const same = std::get_if<Method>(&broad_phase_)) {
      same->plan(parameters);
    } else {
      broad_phase_.template emplace<Method>(parameters);
    }
  }

  void search(Exec& exec, const BodiesView<V>& bodies, ContactRows<Exec>& rows);

  int64_t range_or_list_candidates(Exec& exec) const;

  template <class Method>
  std::vector<int> work_of(Exec& exec, const Method& method) const {
    const auto candidates = method.candidates();
    if constexpr (requires { method.walks(exec); }) {
      return method.walks(exec);
    } else if constexpr (GivesRanges<decltype(candidates)>) {
      typename Exec::template Buffer<int> work;
      work.resize(candidates.threads());
      exec.parallel_for("measure ranges", work.size(), MeasureRanges<decltype(candidates)>{candidates, work.span()});
      return exec.download(work.span());
    } else {
      return exec.download(list_search_.tested());
    }
  }

  /// A search without slots has a thread for each body, in their order.
  template <class Candidates>
  std::vector<int> workers_of(Exec& exec, const Candidates& candidates) const {
    if constexpr (GivesRanges<Candidates>) {
      typename Exec::template Buffer<int> worker;
      worker.resize(candidates.threads());
      exec.parallel_for("name workers", worker.size(), NameWorker<Candidates>{candidates, worker.span()});
      return exec.download(worker.span());
    } else {
      std::vector<int> worker(static_cast<size_t>(list_search_.tested().size()));
      std::iota(worker.begin(), worker.end(), 0);
      return worker;
    }
  }

  // Making a list costs about two searches; one that fails sooner is not made again for a while.
  static constexpr int kWorthwhile = 3;
  static constexpr int kPause = 30;

  Box<V> box_{};
  CandidateList<V, Exec> list_;
  BroadPhase broad_phase_{BruteForce<V, Exec>(BroadPhaseParameters<V>{})};
  ListSearch<V, Exec> list_search_;
  RangeSearch<V, Exec> range_search_;
  ListFilter<V, Exec> list_filter_;
  ContactRows<Exec> rows_;
  bool is_list_last_ = false;
  int list_uses_ = kWorthwhile;
  int pause_ = 0;
  int64_t searches_ = 0;
};

template <class V, class Exec>
void Detector<V, Exec>::plan(ballpit::BroadPhase method, BroadPhaseParameters<V> parameters, double skin) {
  box_ = parameters.box;
  list_.plan(skin, 2 * rounding_guard(parameters.box));
  for (SizeClass<V>& spheres : parameters.classes) spheres.largest *= list_.factor();
  if (method == ballpit::BroadPhase::brute_force) use<BruteForce<V, Exec>>(parameters);
  if (method == ballpit::BroadPhase::sort_and_sweep) use<SortAndSweep<V, Exec>>(parameters);
  if (method == ballpit::BroadPhase::linked_cell) use<LinkedCell<V, Exec>>(parameters);
  if (method == ballpit::BroadPhase::sorted_grid) use<SortedGrid<V, Exec>>(parameters);
  is_list_last_ = false;
  list_uses_ = kWorthwhile;
  pause_ = 0;
  searches_ = 0;
}

template <class V, class Exec>
void Detector<V, Exec>::find(Exec& exec, const BodiesView<V>& bodies) {
  if (has_list(exec, bodies)) {
    list_filter_.find(exec, list_.candidates(), bodies, box_, rows_);
  } else {
    search(exec, bodies, rows_);
  }
}

template <class V, class Exec>
NearPairs Detector<V, Exec>::near_pairs(Exec& exec, const BodiesView<V>& bodies) {
  if (has_list(exec, bodies)) return {list_.candidates().pairs, list_.candidates().first, searches_, false};
  search(exec, bodies, rows_);
  return contacts();
}

template <class V, class Exec>
bool Detector<V, Exec>::shows_all_inside(Exec& exec, const BodiesView<V>& bodies) {
  return list_.is_used() && pause_ == 0 && list_.shows_all_inside() && list_.is_valid(exec, bodies, box_);
}

template <class V, class Exec>
int64_t Detector<V, Exec>::candidates(Exec& exec) const {
  return is_list_last_ ? list_.candidates().pairs.size() : range_or_list_candidates(exec);
}

template <class V, class Exec>
std::vector<GridInspection> Detector<V, Exec>::inspect(Exec& exec, const BodiesView<V>& bodies) {
  return std::visit(
      [&](auto& method) {
        if (list_.is_used()) method.prepare(exec, list_.grown(exec, bodies));
        return method.inspect(exec);
      },
      broad_phase_);
}

template <class V, class Exec>
std::vector<Pair> Detector<V, Exec>::candidate_pairs(Exec& exec, const BodiesView<V>& bodies) const {
  return std::visit([&](auto& method) { return ballpit::candidate_pairs(exec, method.candidates(), bodies.size()); },
                    broad_phase_);
}

template <class V, class Exec>
void Detector<V, Exec>::inspect_sweep(Exec& exec, const BodiesView<V>& bodies, Inspection& seen) const {
  if (const auto* const sweep = std::get_if<SortAndSweep<V, Exec>>(&broad_phase_)) {
    seen.axis = sweep->axis();
    seen.endpoints = sweep->endpoints(exec, bodies);
  }
}

template <class V, class Exec>
std::vector<int> Detector<V, Exec>::work_per_thread(Exec& exec) const {
  return std::visit([&](auto& method) { return work_of(exec, method); }, broad_phase_);
}

template <class V, class Exec>
std::vector<int> Detector<V, Exec>::body_per_thread(Exec& exec) const {
  return std::visit([&](auto& method) { return workers_of(exec, method.candidates()); }, broad_phase_);
}

template <class V, class Exec>
int64_t Detector<V, Exec>::bytes() const {
  return std::visit([](auto& method) { return method.bytes(); }, broad_phase_) + list_search_.bytes() +
         range_search_.bytes() + list_filter_.bytes() + rows_.bytes() + list_.bytes();
}

template <class V, class Exec>
bool Detector<V, Exec>::has_list(Exec& exec, const BodiesView<V>& bodies) {
  is_list_last_ = false;
  if (!list_.is_used()) return false;
  if (pause_ > 0) {
    --pause_;
    return false;
  }
  if (!list_.is_valid(exec, bodies, box_)) {
    if (list_uses_ < kWorthwhile) {
      // It was not used often enough to be worth its making: something is too fast. Try again later.
      pause_ = kPause;
      list_uses_ = kWorthwhile;
      return false;
    }
    search(exec, list_.grown(exec, bodies), list_.rows());
    list_.start(exec, bodies, box_);
    list_uses_ = 0;
  }
  ++list_uses_;
  return is_list_last_ = true;
}

template <class V, class Exec>
void Detector<V, Exec>::search(Exec& exec, const BodiesView<V>& bodies, ContactRows<Exec>& rows) {
  is_list_last_ = false;
  ++searches_;
  std::visit(
      [&](auto& method) {
        method.prepare(exec, bodies);
        const auto candidates = method.candidates();
        if constexpr (GivesRanges<decltype(candidates)>) {
          range_search_.find(exec, candidates, box_, bodies.size(), rows);
        } else {
          list_search_.find(exec, candidates, bodies, box_, rows);
        }
      },
      broad_phase_);
}

template <class V, class Exec>
int64_t Detector<V, Exec>::range_or_list_candidates(Exec& exec) const {
  return std::visit(
      [&](auto& method) {
        if constexpr (GivesRanges<decltype(method.candidates())>) {
          return range_search_.candidates(exec);
        } else {
          return list_search_.candidates(exec);
        }
      },
      broad_phase_);
}

}  // namespace ballpit
