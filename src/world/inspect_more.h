// SPDX-License-Identifier: MIT
// What an inspection holds only where it is wanted: found by detectors made for the moment and without candidate lists,
// so that the world's own stays as it is, its counts and the times of its stages included.
//
// Cost: a search for candidates, endpoints and work; one by brute force for what was missed.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "bodies/pair.h"
#include "exec/stage_times.h"
#include "world/inspection.h"
#include "world/step_state.h"

namespace ballpit {

/// Contacts by brute force that are not among those found.
template <class V, class Exec>
std::vector<Pair> missed_pairs(StepState<V, Exec>& state, const std::vector<Pair>& found) {
  Detector<V, Exec> oracle(BroadPhase::brute_force, state.parameters(), 0);
  oracle.find(state.exec(), state.bodies());
  const std::vector<Pair> all = state.exec().download(oracle.pairs());
  std::vector<Pair> missed;
  std::set_difference(all.begin(), all.end(), found.begin(), found.end(), std::back_inserter(missed));
  return missed;
}

/// Adds what is wanted to an inspection that holds the contacts. Bodies are named by their places, as there.
template <class V, class Exec>
void inspect_more(StepState<V, Exec>& state, const Wanted& wanted, Inspection& seen) {
  Exec& exec = state.exec();
  const StageTimes times = exec.stage_times();
  if (wanted.candidates || wanted.endpoints || wanted.work) {
    Detector<V, Exec> detector(state.choice().method, state.parameters(), 0);
    detector.find(exec, state.bodies());
    if (wanted.candidates) seen.candidates = detector.candidate_pairs(exec, state.bodies());
    if (wanted.endpoints) detector.inspect_sweep(exec, state.bodies(), seen);
    if (wanted.work) {
      seen.work = detector.work_per_thread(exec);
      seen.worker = detector.body_per_thread(exec);
    }
  }
  if (wanted.missed) seen.missed = missed_pairs(state, seen.contacts);
  exec.stage_times() = times;
}

}  // namespace ballpit
