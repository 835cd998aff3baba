// SPDX-License-Identifier: MIT
// What an inspection holds only where it is wanted. It is found by colliders made for the moment, without candidate lists, so
// that the world's own stays as it is, with its counts and the times of its stages.
//
// Cost: a search for candidates, endpoints and work; one by brute force for what was missed.
#pragma once

#include <algorithm>
#include <iterator>
#include <numeric>

#include "narrow_phase/candidate_pairs.h"
#include "narrow_phase/collider.h"
#include "world/body_store.h"

namespace ballpit {

/// Kernel: how many slots thread t looks at, and the body that it does so for, or −1.
template <class Candidates>
struct MeasureRanges {
  Candidates candidates;
  Span<int> work, worker;

  HOST_DEVICE void operator()(int t) const {
    int sum = 0;
    const int slot = candidates.slot_of(t);
    if (slot >= 0) candidates.for_each_range(slot, [&](const SlotRange& range) { sum += range.size(); });
    work[t] = sum;
    worker[t] = slot >= 0 ? candidates.slots().body[slot] : -1;
  }
};

/// The work of a search, thread by thread.
struct ThreadWork {
  std::vector<int> work;    ///< in the units of the method
  std::vector<int> worker;  ///< the body that each thread works for, or −1
};

/// Of the last search that `collider` made without a candidate list.
template <class V, class Exec>
ThreadWork thread_work(Exec& exec, const Collider<V, Exec>& collider) {
  return std::visit(
      [&](const auto& method) {
        const auto candidates = method.candidates();
        ThreadWork result;
        if constexpr (GivesRanges<decltype(candidates)>) {
          typename Exec::template Buffer<int> work, worker;
          work.resize(candidates.threads());
          worker.resize(candidates.threads());
          exec.parallel_for("measure ranges", work.size(),
                            MeasureRanges<decltype(candidates)>{candidates, work.span(), worker.span()});
          result = {exec.download(work.span()), exec.download(worker.span())};
        } else {  // a thread for each body, in their order
          result.work = exec.download(collider.tested());
          result.worker.resize(result.work.size());
          std::iota(result.worker.begin(), result.worker.end(), 0);
        }
        if constexpr (requires { method.walks(exec); }) result.work = method.walks(exec);
        return result;
      },
      collider.broad_phase());
}

/// Contacts by brute force that are not among those found.
template <class V, class Exec>
std::vector<Pair> missed_pairs(const BodyStore<V, Exec>& bodies, const BroadPhaseParameters<V>& parameters,
                               const std::vector<Pair>& found) {
  Collider<V, Exec> oracle;
  oracle.plan({BroadPhase::brute_force, ""}, parameters, 0);
  const std::vector<Pair> all = bodies.exec().download(oracle.pairs(bodies.exec(), bodies.view()));
  std::vector<Pair> missed;
  std::set_difference(all.begin(), all.end(), found.begin(), found.end(), std::back_inserter(missed));
  return missed;
}

/// Adds what is wanted to an inspection that holds the contacts found by `collider`. Bodies are named by their slots, as there.
template <class V, class Exec>
void inspect_more(const BodyStore<V, Exec>& bodies, const Collider<V, Exec>& collider, const Wanted& wanted,
                  Inspection& seen) {
  Exec& exec = bodies.exec();
  const StageTimes times = exec.stage_times();
  if (wanted.candidates || wanted.endpoints || wanted.work) {
    Collider<V, Exec> search;
    search.plan(collider.choice(), collider.parameters(), 0);
    search.pairs(exec, bodies.view());
    if (wanted.candidates) {
      seen.candidates =
          std::visit([&](const auto& method) { return candidate_pairs(exec, method.candidates(), bodies.count()); },
                     search.broad_phase());
    }
    const auto* const sweep = std::get_if<SortAndSweep<V, Exec>>(&search.broad_phase());
    if (wanted.endpoints && sweep) {
      seen.axis = sweep->axis();
      seen.endpoints = sweep->endpoints(exec, bodies.view());
    }
    if (wanted.work) {
      ThreadWork work = thread_work(exec, search);
      seen.work = std::move(work.work);
      seen.worker = std::move(work.worker);
    }
  }
  if (wanted.missed) seen.missed = missed_pairs(bodies, collider.parameters(), seen.contacts);
  exec.stage_times() = times;
}

}  // namespace ballpit
