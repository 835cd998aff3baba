// SPDX-License-Identifier: MIT
#include "report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "measure/machine.h"

namespace ballpit {

using Json = nlohmann::ordered_json;

namespace {

/// "12.3 (0.4)": the median and the distance between the quartiles.
std::string with_spread(const PeerTiming& timing) {
  return fmt::format("{:9.3g} ({:.2g})", timing.median, timing.spread);
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
  return fmt::format("{:8} {:7} {:16} {:>18} {:>18} {:>8} {:>9}  {}\n", "family", "mode", "peer", "ours ms (IQR)",
                     "peer ms (IQR)", "ratio", "pairs", "sets");
}

std::string table_line(const Row& row) {
  return fmt::format("{:8} {:7} {:16} {:>18} {:>18} {:8.2f} {:9}  {}\n", row.family, row.mode, row.peer,
                     with_spread(row.ours), with_spread(row.theirs), row.ratio(), row.pairs,
                     row.equal ? "equal" : "DIFFER");
}

std::string table_foot(const std::vector<Summary>& summaries) {
  std::string text = fmt::format("\n{:16} {:7} {:>15} {:>8}\n", "peer", "mode", "geometric mean", "worst");
  for (const Summary& s : summaries) {
    text +=
        fmt::format("{:16} {:7} {:15.2f} {:8.2f}  ({})\n", s.peer, s.mode, s.geometric_mean, s.worst, s.worst_family);
  }
  return text;
}

std::string csv_of(const std::vector<Row>& rows) {
  std::string text = "family,count,threads,peer,mode,ours_ms,ours_iqr_ms,peer_ms,peer_iqr_ms,ratio,pairs,equal\n";
  for (const Row& row : rows) {
    text += fmt::format("{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{}\n", row.family, row.count, row.threads,
                        row.peer, row.mode, row.ours.median, row.ours.spread, row.theirs.median, row.theirs.spread,
                        row.ratio(), row.pairs, row.equal ? "yes" : "no");
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
  const Json described = describe_machine();
  return {{"cpu", described["cpu"]},
          {"cores", described["cores"]},
          {"compiler", __VERSION__},
          {"build", described["build_type"]}};
}

}  // namespace ballpit
