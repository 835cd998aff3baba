// SPDX-License-Identifier: MIT
// How unevenly the work of a search lies on its threads, and what a GPU's lockstep makes of that.
#include "lab/experiments/experiments.h"

namespace ballpit {

namespace {

int64_t measurements(bool) { return 0; }

Findings run(Lab&) { return {}; }

}  // namespace

Experiment divergence_experiment() {
  return {"divergence",
          "Work per thread",
          "How evenly is the work of a search spread over its threads, and what does a GPU lose by that?",
          1,
          1,
          measurements,
          run};
}

}  // namespace ballpit
