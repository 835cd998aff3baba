// SPDX-License-Identifier: MIT
// What an inspection holds only where it is wanted. It is found by colliders made for the moment, without candidate
// lists, so that the world's own stays as it is, with its counts and the times of its stages. Cost: a search for
// candidates, endpoints and work; one by brute force for what was missed.
#pragma once

#include <algorithm>
#include <iterator>
#include <numeric>

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

/// The work of each thread, in the units of the method, and the body that it works for, or −1: of the last search that
/// `collider` made without a candidate list.
template <class V, class Exec>
std::pair<std::vector<int>, std::vector<int>> thread_work(Exec& exec, const Collider<V, Exec>& collider) {
  return std::visit(
      [&](const auto& method) {
        std::pair<std::vector<int>, std::vector<int>> result;
        auto& [work, worker] = result;
        if constexpr (lecture::FindsPairs<decltype(method)>) {
          return method.work(exec);
        } else if constexpr (GivesRanges<decltype(method.candidates())>) {
          const auto candidates = method.candidates();
          typename Exec::template Buffer<int> sums, bodies;
          sums.resize(candidates.threads());
          bodies.resize(candidates.threads());
          exec.parallel_for("measure ranges", sums.size(),
                            MeasureRanges<decltype(candidates)>{candidates, sums.span(), bodies.span()});
          result = {exec.download(sums.span()), exec.download(bodies.span())};
        } else {  // a thread for each body, in their order
          work = exec.download(collider.tested());
          worker.resize(work.size());
          std::iota(worker.begin(), worker.end(), 0);
        }
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

/// Adds what is wanted to an inspection that holds the contacts found by `collider`. Bodies are named by their slots,
/// as there.
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
      seen.candidates = std::visit(
          [&](auto& method) {
            if constexpr (lecture::FindsPairs<decltype(method)>) {
              ContactRows<Exec> rows;
              put_into_rows(exec, method.list_candidates(exec, bodies.view()), bodies.count(), rows);
              return exec.download(rows.pairs());
            } else {
              return candidate_pairs(exec, method.candidates(), bodies.view(), bodies.box());
            }
          },
          search.prepared(exec, bodies.view()));
    }
    if (wanted.endpoints) {
      std::visit(
          [&](const auto& method) {
            if constexpr (requires { method.endpoints(exec, bodies.view()); }) {
              seen.axis = method.axis();
              seen.endpoints = method.endpoints(exec, bodies.view());
            }
          },
          search.broad_phase());
    }
    if (wanted.work) std::tie(seen.work, seen.worker) = thread_work(exec, search);
  }
  if (wanted.missed) seen.missed = missed_pairs(bodies, collider.parameters(), seen.contacts);
  exec.stage_times() = times;
}

}  // namespace ballpit
