// SPDX-License-Identifier: MIT
// Timings of steps as JSON and as a table, with the machine that they were measured on.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "measure/step_timing.h"

namespace ballpit {

/// Machine, scene, and an entry a timing: medians and quartiles, the speedup against the plan's first method on the
/// same processor, contacts, candidates, stages; or why it was skipped.
nlohmann::ordered_json summarize(const TimingPlan& plan, const std::vector<StepTiming>& timings);

/// The same for people, on standard output.
void print_table(const nlohmann::ordered_json& summary, bool with_stages);

}  // namespace ballpit
