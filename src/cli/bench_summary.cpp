// SPDX-License-Identifier: MIT
#include "cli/bench_summary.h"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "measure/gas.h"
#include "measure/machine.h"
#include "measure/statistics.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

bool is_same_setup(const StepTiming& a, const StepTiming& b) {
  return a.count == b.count && a.which.backend.name == b.which.backend.name && a.which.threads == b.which.threads;
}

/// How many times as fast as the first method at the same count, backend and threads; nothing where that was skipped.
Json speedup_of(const StepTiming& timing, const std::vector<StepTiming>& all) {
  const auto first =
      std::find_if(all.begin(), all.end(), [&](const StepTiming& t) { return is_same_setup(t, timing); });
  if (first->seconds.empty()) return {};
  return spread_of(first->seconds).median / spread_of(timing.seconds).median;
}

Json summarize_timing(const StepTiming& timing, const std::vector<StepTiming>& all) {
  Json entry{{"count", timing.count}, {"method", timing.which.method}, {"backend", timing.which.backend.name}};
  entry["threads"] = timing.which.threads > 0 ? Json(timing.which.threads) : Json();
  if (!timing.skipped.empty()) {
    entry["skipped"] = timing.skipped;
    return entry;
  }
  const Spread spread = spread_of(timing.seconds);
  entry["seconds"] = spread.median;
  entry["seconds_min"] = spread.least;
  entry["seconds_quartiles"] = {spread.lower, spread.upper};
  entry["speedup"] = speedup_of(timing, all);
  entry["steps"] = timing.steps;
  entry["contacts"] = timing.contacts;
  entry["candidates"] = timing.candidates;
  entry["stages"] = Json::array();
  for (const StepStage& stage : timing.stages) {
    entry["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"launches", stage.launches}});
  }
  return entry;
}

void print_stages(const Json& entry) {
  for (const Json& stage : entry["stages"]) {
    const double seconds = stage["seconds"];
    if (seconds < 0.01 * entry["seconds"].get<double>()) continue;
    std::printf("%9s    %-22s %14.4f\n", "", stage["name"].get<std::string>().c_str(), 1e3 * seconds);
  }
}

void print_entry(const Json& entry) {
  const std::string threads = entry["threads"].is_number() ? entry["threads"].dump() : "-";
  std::printf("%9lld  %-15s %-7s %7s  ", static_cast<long long>(entry["count"].get<int64_t>()),
              entry["method"].get<std::string>().c_str(), entry["backend"].get<std::string>().c_str(), threads.c_str());
  if (entry.contains("skipped")) {
    std::printf("skipped: %s\n", entry["skipped"].get<std::string>().c_str());
    return;
  }
  const double seconds = entry["seconds"];
  const Json& quartiles = entry["seconds_quartiles"];
  std::printf("%10.4f  %9.4f to %9.4f  %11.1f", 1e3 * seconds, 1e3 * quartiles[0].get<double>(),
              1e3 * quartiles[1].get<double>(), 1e9 * seconds / entry["count"].get<double>());
  if (entry["speedup"].is_number()) std::printf("  %7.1f", entry["speedup"].get<double>());
  std::puts("");
}

}  // namespace

Json summarize(const TimingPlan& plan, const std::vector<StepTiming>& timings) {
  Json entries = Json::array();
  for (const StepTiming& timing : timings) entries.push_back(summarize_timing(timing, timings));
  return {{"machine", describe_machine()}, {"volume_fraction", kGasVolumeFraction}, {"dt", kGasStep},
          {"repeat", plan.blocks},         {"baseline", plan.cases.front().method}, {"entries", entries}};
}

void print_table(const Json& summary, bool with_stages) {
  const Json& machine = summary["machine"];
  std::printf("%s, %s cores", machine["cpu"].get<std::string>().c_str(), machine["cores"].dump().c_str());
  if (machine.contains("cuda")) std::printf("; %s", machine["cuda"].get<std::string>().c_str());
  std::printf("; %s, %s\n", machine["compiler"].get<std::string>().c_str(),
              machine["build_type"].get<std::string>().c_str());
  std::printf("a gas of equal elastic spheres, %.0f %% of the volume; medians and quartiles of %s blocks of steps\n",
              100 * kGasVolumeFraction, summary["repeat"].dump().c_str());
  std::printf("speedup: against %s on the same processor\n\n", summary["baseline"].get<std::string>().c_str());
  std::printf("%9s  %-15s %-7s %7s  %10s  %22s  %11s  %7s\n", "spheres", "method", "backend", "threads", "ms a step",
              "quartiles", "ns a sphere", "speedup");
  for (const Json& entry : summary["entries"]) {
    print_entry(entry);
    if (with_stages && entry.contains("stages")) print_stages(entry);
  }
}

}  // namespace ballpit
