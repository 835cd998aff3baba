// SPDX-License-Identifier: MIT
// What runs as one launch of several phases, each of which reads what the one before has written. Only the device need know
// how many phases there are, and of how many indices:
//
//     exec.run_phases(name, most, phases)      while (phases.next()) phases(k) for each k in 0 … phases.size() − 1
//
// Each thread has a copy of the phases, so next() must do the same in all of them: what it reads may be written in the phase
// before, but not in the one that it begins. A GPU has a barrier among all of its blocks after each phase
// (cuda/phase_kernel.h).
#pragma once

#include <concepts>

namespace ballpit {

template <class P>
concept Phases = requires(P phases, const P fixed, int k) {
  { phases.next() } -> std::same_as<bool>;
  { fixed.size() } -> std::same_as<int>;
  fixed(k);
};

}  // namespace ballpit
