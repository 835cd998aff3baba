// SPDX-License-Identifier: MIT
#include "report.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

/// As printf; a line of at most 255 bytes.
[[gnu::format(printf, 1, 2)]] std::string line(const char* format, ...) {
  char text[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof(text), format, arguments);
  va_end(arguments);
  return text;
}

/// "12.3 ± 0.4" with three significant digits or so, the second number being the quartiles' distance.
std::string with_spread(const Timing& timing) { return line("%9.3g (%.2g)", timing.median, timing.spread); }

std::string cpu_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string text; std::getline(in, text);) {
    if (text.rfind("model name", 0) == 0) return text.substr(text.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

std::vector<Summary> summarize(const std::vector<Row>& rows) {
  std::vector<Summary> summaries;
  std::vector<int> counts;
  for (const Row& row : rows) {
    const auto same = [&row](const Summary& s) { return s.peer == row.peer && s.mode == row.mode; };
    auto found = std::find_if(summaries.begin(), summaries.end(), same);
    if (found == summaries.end()) {
      found = summaries.insert(found, {row.peer, row.mode, 0.0, row.ratio(), row.family});
      counts.push_back(0);
    }
    found->geometric_mean += std::log(row.ratio());
    ++counts[static_cast<size_t>(found - summaries.begin())];
    if (row.ratio() < found->worst) {
      found->worst = row.ratio();
      found->worst_family = row.family;
    }
  }
  for (size_t k = 0; k < summaries.size(); ++k) {
    summaries[k].geometric_mean = std::exp(summaries[k].geometric_mean / counts[k]);
  }
  return summaries;
}

std::string table_head() {
  return line("%-8s %-7s %-16s %18s %18s %8s %9s  %s\n", "family", "mode", "peer", "ours ms (IQR)", "peer ms (IQR)",
              "ratio", "pairs", "sets");
}

std::string table_line(const Row& row) {
  return line("%-8s %-7s %-16s %18s %18s %8.2f %9lld  %s\n", row.family.c_str(), row.mode.c_str(), row.peer.c_str(),
              with_spread(row.ours).c_str(), with_spread(row.theirs).c_str(), row.ratio(),
              static_cast<long long>(row.pairs), row.equal ? "equal" : "DIFFER");
}

std::string table_foot(const std::vector<Summary>& summaries) {
  std::string text = line("\n%-16s %-7s %15s %8s\n", "peer", "mode", "geometric mean", "worst");
  for (const Summary& s : summaries) {
    text += line("%-16s %-7s %15.2f %8.2f  (%s)\n", s.peer.c_str(), s.mode.c_str(), s.geometric_mean, s.worst,
                 s.worst_family.c_str());
  }
  return text;
}

std::string csv_of(const std::vector<Row>& rows) {
  std::string text = "family,count,threads,peer,mode,ours_ms,ours_iqr_ms,peer_ms,peer_iqr_ms,ratio,pairs,equal\n";
  for (const Row& row : rows) {
    text += line("%s,%lld,%d,%s,%s,%.6g,%.6g,%.6g,%.6g,%.6g,%lld,%s\n", row.family.c_str(),
                 static_cast<long long>(row.count), row.threads, row.peer.c_str(), row.mode.c_str(), row.ours.median,
                 row.ours.spread, row.theirs.median, row.theirs.spread, row.ratio(), static_cast<long long>(row.pairs),
                 row.equal ? "yes" : "no");
  }
  return text;
}

Json json_of(const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) {
    list.push_back({{"family", row.family},
                    {"count", row.count},
                    {"threads", row.threads},
                    {"peer", row.peer},
                    {"mode", row.mode},
                    {"ours_ms", row.ours.median},
                    {"ours_iqr_ms", row.ours.spread},
                    {"peer_ms", row.theirs.median},
                    {"peer_iqr_ms", row.theirs.spread},
                    {"ratio", row.ratio()},
                    {"pairs", row.pairs},
                    {"equal", row.equal}});
  }
  return list;
}

Json machine() {
  return {{"cpu", cpu_name()},
          {"cores", std::thread::hardware_concurrency()},
          {"compiler", __VERSION__},
          {"build", BALLPIT_BUILD_TYPE}};
}

}  // namespace ballpit
