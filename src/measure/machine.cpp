// SPDX-License-Identifier: MIT
#include "measure/machine.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "version.h"
#include "world/world.h"

namespace ballpit {

int thread_count(int threads) {
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::string cpu_model() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

nlohmann::ordered_json describe_machine() {
  nlohmann::ordered_json machine{{"cpu", cpu_model()}, {"cores", thread_count(0)}};
  const Backend cuda = cuda_backend();
  if (cuda.unavailable_reason.empty()) machine["cuda"] = cuda.description;
  machine["compiler"] = kCompiler;
  machine["build_type"] = kBuildType;
  machine["version"] = kVersion;
  return machine;
}

std::string machine_line() {
  const Backend cuda = cuda_backend();
  return fmt::format("{}, {} cores; {}{}, {}; ballpit {}", cpu_model(), thread_count(0),
                     cuda.unavailable_reason.empty() ? cuda.description + "; " : "", kCompiler, kBuildType, kVersion);
}

}  // namespace ballpit
