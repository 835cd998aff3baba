// SPDX-License-Identifier: MIT
#include "cli/pairs_summary.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/summary.h"
#include "measure/statistics.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

Json list_work(const WorkProfile& work) {
  Json histogram = Json::array();
  for (const WorkBin& bin : work.bins) {
    histogram.push_back({{"from", bin.low}, {"to", bin.high}, {"threads", bin.threads}});
  }
  Json list{{"threads", work.threads}, {"max", work.most}, {"mean", work.mean}, {"histogram", histogram}};
  list["warp_size"] = kWarpSize;
  list["simd_efficiency"] = work.simd_efficiency ? Json(*work.simd_efficiency) : Json();
  return list;
}

void add_seconds(Json& summary, const std::vector<double>& seconds) {
  const Spread spread = spread_of(seconds);
  summary["seconds"] = spread.median;
  if (seconds.size() < 2) return;
  summary["seconds_min"] = spread.least;
  summary["seconds_quartiles"] = {spread.lower, spread.upper};
}

/// Stages of one search out of many, on average.
std::vector<Stage> mean_of(std::vector<Stage> stages, int64_t searches) {
  for (Stage& stage : stages) {
    stage.seconds /= static_cast<double>(searches);
    stage.launches /= searches;
  }
  return stages;
}

std::string percent(double fraction) { return std::to_string(std::lround(100 * fraction)) + " %"; }

std::string describe_method(const Json& summary) {
  std::string text = summary["method"].get<std::string>() + ", " + summary["backend"].get<std::string>();
  if (summary["threads"].is_number()) text += ", " + summary["threads"].dump() + " threads";
  if (summary.contains("reason")) text += "; chosen by auto: " + summary["reason"].get<std::string>();
  return text;
}

std::string describe_work(const Json& work) {
  std::ostringstream text;
  text << work["mean"].get<double>() << " a thread on average, at most " << work["max"];
  const Json& efficiency = work["simd_efficiency"];
  if (efficiency.is_number()) text << "; warps of " << work["warp_size"] << " busy to " << percent(efficiency);
  return text.str();
}

}  // namespace

Json summarize(const PairsOutcome& outcome) {
  const SearchReport& report = outcome.report;
  Json summary{{"file", outcome.file}, {"count", outcome.count}};
  if (outcome.period) summary["period"] = {outcome.period->x, outcome.period->y, outcome.period->z};
  summary["method"] = report.method;
  if (!report.reason.empty()) summary["reason"] = report.reason;
  summary["backend"] = outcome.backend;
  summary["threads"] = outcome.threads > 0 ? Json(outcome.threads) : Json();
  summary["contacts"] = report.contacts;
  summary["candidates"] = report.candidates;
  if (outcome.deviation) {
    summary["missed"] = outcome.deviation->missed;
    summary["wrong"] = outcome.deviation->wrong;
    summary["duplicate"] = outcome.deviation->duplicate;
  }
  summary["repeat"] = outcome.seconds.size();
  add_seconds(summary, outcome.seconds);
  summary["bytes"] = report.bytes;
  summary["work"] = list_work(outcome.work);
  summary["stages"] = list_stages(mean_of(report.stages, static_cast<int64_t>(outcome.seconds.size())));
  return summary;
}

std::string describe_pairs(const Json& summary) {
  std::ostringstream text;
  const auto line = [&](const char* label) -> std::ostream& {
    char padded[24];
    std::snprintf(padded, sizeof(padded), "%-18s", label);
    return text << padded;
  };
  line("spheres") << summary["count"] << " in " << summary["file"].get<std::string>() << "\n";
  if (summary.contains("period")) {
    const Json& period = summary["period"];
    line("period") << period[0] << ", " << period[1] << ", " << period[2] << " m\n";
  } else {
    line("period") << "none\n";
  }
  line("method") << describe_method(summary) << "\n";
  line("took") << summary["seconds"].get<double>() << " s";
  if (summary.contains("seconds_min")) {
    const Json& quartiles = summary["seconds_quartiles"];
    text << ", the median of " << summary["repeat"] << " searches; quartiles " << quartiles[0].get<double>()
         << " s and " << quartiles[1].get<double>() << " s";
  }
  text << "\n";
  line("memory") << summary["bytes"].get<double>() / 1e6 << " MB\n";
  line("contacts") << summary["contacts"] << " among " << summary["candidates"] << " candidates\n";
  line("work") << describe_work(summary["work"]) << "\n";
  if (summary.contains("missed")) {
    line("against exact") << summary["missed"] << " missed, " << summary["wrong"] << " wrong, " << summary["duplicate"]
                          << " duplicate\n";
  }
  return text.str();
}

std::string pairs_csv(const std::vector<Pair>& pairs) {
  std::string text = "i,j\n";
  text.reserve(text.size() + 16 * pairs.size());
  std::array<char, 24> row;  // two numbers of at most ten digits
  for (const Pair& pair : pairs) {
    char* end = std::to_chars(row.data(), row.data() + 11, pair.i).ptr;
    *end++ = ',';
    end = std::to_chars(end, row.data() + row.size() - 1, pair.j).ptr;
    *end++ = '\n';
    text.append(row.data(), end);
  }
  return text;
}

}  // namespace ballpit
