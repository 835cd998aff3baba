// SPDX-License-Identifier: MIT
// The machine and the build, on which measured times depend.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace ballpit {

/// The number of threads for `--threads`: 0 stands for one per core.
int thread_count(int threads);

/// "AMD EPYC 9354": the first processor that Linux lists.
std::string cpu_model();

/// CPU, cores, CUDA device if there is one, compiler, build type, version.
nlohmann::ordered_json describe_machine();

/// The same on one line: "Xeon, 2 cores; GNU 12.2.0, Release; ballpit 0.1.0".
std::string machine_line();

}  // namespace ballpit
