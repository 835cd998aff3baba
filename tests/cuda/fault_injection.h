// SPDX-License-Identifier: MIT
// Failures on demand, and an account of what a run holds and calls: the linker leads every call of the CUDA runtime,
// from this project and from CUB, through a wrapper (--wrap, see CMakeLists.txt). Nothing else is compiled for it.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace ballpit::faults {

/// The k-th call from now on that can fail does so, without effect; 0 for none. Starts counting anew.
void fail_at(int64_t call);

/// Each call of this function from now on, until fail_at().
void fail_always(const std::string& name);

/// The call that was made to fail ("cudaMalloc"), empty if none was.
std::string failed_call();

/// What has been made and not been given back; and how often something was given back that was not held.
struct Held {
  int64_t allocations = 0, streams = 0, events = 0, graphs = 0, strangers = 0;
  friend bool operator==(const Held&, const Held&) = default;
};
Held held();

/// [byte] copied from the device to the host since fail_at().
int64_t bytes_to_host();

/// Calls by name since fail_at().
const std::map<std::string, int64_t>& calls();

}  // namespace ballpit::faults
