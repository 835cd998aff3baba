// SPDX-License-Identifier: MIT
// The machine and the build that measured times depend on.
#pragma once

#include <nlohmann/json.hpp>

namespace ballpit {

/// Threads that `--threads` asks for: 0 is as many as there are cores.
int thread_count(int threads);

/// CPU, cores, CUDA device where one answers, compiler, build type, version.
nlohmann::ordered_json describe_machine();

}  // namespace ballpit
