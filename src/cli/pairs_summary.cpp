// SPDX-License-Identifier: MIT
#include "cli/pairs_summary.h"

#include <cmath>
#include <iterator>

#include <fmt/compile.h>
#include <nlohmann/json.hpp>

#include "cli/summary.h"
#include "measure/statistics.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

Json json_of(const WorkProfile& work) {
  Json histogram = Json::array();
  for (const WorkBin& bin : work.bins) {
    histogram.push_back({{"from", bin.low}, {"to", bin.high}, {"threads", bin.threads}});
  }
  return {{"threads", work.threads}, {"max", work.most},
          {"mean", work.mean},       {"histogram", histogram},
          {"warp_size", kWarpSize},  {"simd_efficiency", work.simd_efficiency ? Json(*work.simd_efficiency) : Json()}};
}

/// Stages of one search out of many, on average.
std::vector<Stage> mean_of(std::vector<Stage> stages, int64_t searches) {
  for (Stage& stage : stages) {
    stage.seconds /= static_cast<double>(searches);
    stage.launches /= searches;
  }
  return stages;
}

std::string text_of(const WorkProfile& work) {
  std::string text = fmt::format("{:g} a thread on average, at most {}", work.mean, work.most);
  if (!work.simd_efficiency) return text;
  return text + fmt::format("; warps of {} busy to {} %", kWarpSize, std::lround(100 * *work.simd_efficiency));
}

}  // namespace

Json json_of(const PairsOutcome& outcome) {
  const SearchReport& report = outcome.report;
  Json json{{"file", outcome.file}, {"count", outcome.count}};
  if (outcome.period) json["period"] = {outcome.period->x, outcome.period->y, outcome.period->z};
  json["method"] = report.method;
  if (!report.reason.empty()) json["reason"] = report.reason;
  json["backend"] = outcome.backend;
  json["threads"] = outcome.threads > 0 ? Json(outcome.threads) : Json();
  json["contacts"] = report.contacts;
  json["candidates"] = report.candidates;
  if (outcome.deviation) {
    json["missed"] = outcome.deviation->missed;
    json["wrong"] = outcome.deviation->wrong;
    json["duplicate"] = outcome.deviation->duplicate;
  }
  const Spread spread = spread_of(outcome.seconds);
  json["repeat"] = outcome.seconds.size();
  json["seconds"] = spread.median;
  if (outcome.seconds.size() > 1) {
    json["seconds_min"] = spread.least;
    json["seconds_quartiles"] = {spread.lower, spread.upper};
  }
  json["bytes"] = report.bytes;
  json["work"] = json_of(outcome.work);
  json["stages"] = json_of(mean_of(report.stages, static_cast<int64_t>(outcome.seconds.size())));
  return json;
}

std::string text_of(const PairsOutcome& outcome) {
  const SearchReport& report = outcome.report;
  std::string text;
  const auto line = [&](const char* label, const std::string& value) {
    text += fmt::format("{:<18}{}\n", label, value);
  };
  line("spheres", fmt::format("{} in {}", outcome.count, outcome.file));
  if (const auto& period = outcome.period) {
    line("period", fmt::format("{}, {}, {} m", Json(period->x).dump(), Json(period->y).dump(), Json(period->z).dump()));
  } else {
    line("period", "none");
  }
  const std::string threads = outcome.threads > 0 ? fmt::format(", {} threads", outcome.threads) : "";
  const std::string reason = report.reason.empty() ? "" : "; chosen by auto: " + report.reason;
  line("method", fmt::format("{}, {}{}{}", report.method, outcome.backend, threads, reason));
  const Spread spread = spread_of(outcome.seconds);
  std::string took = fmt::format("{:g} s", spread.median);
  if (const size_t repeat = outcome.seconds.size(); repeat > 1) {
    took += fmt::format(", the median of {} searches; quartiles {:g} s and {:g} s", repeat, spread.lower, spread.upper);
  }
  line("took", took);
  line("memory", fmt::format("{:g} MB", static_cast<double>(report.bytes) / 1e6));
  line("contacts", fmt::format("{} among {} candidates", report.contacts, report.candidates));
  line("work", text_of(outcome.work));
  if (const auto& found = outcome.deviation) {
    line("against exact",
         fmt::format("{} missed, {} wrong, {} duplicate", found->missed, found->wrong, found->duplicate));
  }
  return text;
}

std::string pairs_csv(const std::vector<Pair>& pairs) {
  std::string text = "i,j\n";
  text.reserve(text.size() + 16 * pairs.size());
  for (const Pair& pair : pairs) fmt::format_to(std::back_inserter(text), FMT_COMPILE("{},{}\n"), pair.i, pair.j);
  return text;
}

}  // namespace ballpit
