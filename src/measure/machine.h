// SPDX-License-Identifier: MIT
// The machine and the build that measured times depend on.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace ballpit {

/// Threads that `--threads` asks for: 0 is as many as there are cores.
int thread_count(int threads);

/// CPU, cores, CUDA device where one answers, compiler, build type, version.
nlohmann::ordered_json describe_machine();

/// The same on one line: "Xeon, 2 cores; GNU 12.2.0, Release; ballpit 0.1.0".
std::string machine_line();

}  // namespace ballpit
