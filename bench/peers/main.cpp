// SPDX-License-Identifier: MIT
// Our pair search against those of other libraries, on families of spheres that differ in density, size and shape.
//
//     bench_peers                                     all families, all libraries, 100 000 spheres
//     bench_peers --families u30,poly --peers embree --mode cold --csv peers.csv
//
// docs/benchmarks.md says what is measured. Exit status: 0 done, 1 pairs differ or the run failed, 2 wrong options.
#include <algorithm>
#include <iostream>

#include <nlohmann/json.hpp>

#include "command_line.h"
#include "compare.h"
#include "core/file.h"
#include "core/heap.h"
#include "methods/settings.h"
#include "report.h"

using namespace ballpit;

namespace {

struct Options {
  std::vector<std::string> families;
  std::vector<std::string> peers;
  std::string mode = "both";
  int64_t count = 100000;
  uint64_t seed = 1;
  int64_t steps = 50;
  Protocol protocol;
  std::string clock = "wall";
  PeerOptions search;
  double skin = 0.1;
  bool json = false;
  std::string csv;
};

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const FamilyInfo& family : families()) names.emplace_back(family.name);
  return names;
}

std::vector<std::string> peer_names() {
  std::vector<std::string> names;
  for (const PeerInfo& peer : peer_table()) names.push_back(peer.name);
  return names;
}

void check(const Options& options) {
  require_names("--families", options.families, family_names());
  require_names("--peers", options.peers, peer_names());
  require_names("--mode", {options.mode}, {"cold", "update", "both"});
  require_names("--clock", {options.clock}, {"wall", "cpu"});
  require(options.clock == "wall" || options.search.threads == 1, "--clock", "cpu with several threads", "wall");
  require_range("--count", options.count, 1, 100'000'000);
  require_range("--threads", options.search.threads, 1, 256);
  require_range("--repeat", options.protocol.cold, 1, 10'000);
  require_range("--drifts", options.protocol.drifts, 1, 10'000);
  require_range("--steps", options.steps, 1, 10'000);
  require(options.skin >= 0 && options.skin <= 10, "--skin", std::to_string(options.skin), "0 to 10");
  Settings settings;
  apply_setting(settings, "broadphase", options.search.broadphase, "--broadphase");
}

void add_options(CLI::App& app, Options& options) {
  const auto add = [&app](const char* name, auto& value, const char* type, const std::string& help) {
    return app.add_option(name, value, help)->type_name(type);
  };
  app.option_defaults()->always_capture_default();
  add("--families", options.families, "NAMES", "families of spheres")->delimiter(',');
  add("--peers", options.peers, "NAMES", "libraries to compare with")->delimiter(',');
  add("--mode", options.mode, "MODE", "what is timed: cold, update, both");
  add("--count", options.count, "N", "spheres");
  add("--seed", options.seed, "N", "start of the random numbers");
  add("--threads", options.search.threads, "N", "for ours, and for libraries that offer it");
  add("--repeat", options.protocol.cold, "N", "cold searches");
  add("--drifts", options.protocol.drifts, "N", "runs of updates");
  add("--steps", options.steps, "N", "updates in a run");
  add("--broadphase", options.search.broadphase, "NAME", "ours");
  add("--skin", options.skin, "NUMBER", "ours, in updates, as a fraction of the radius");
  add("--clock", options.clock, "NAME", "wall, or cpu: time of the process, for one thread on a busy machine");
  add("--csv", options.csv, "FILE", "write the rows to a file as well");
  app.add_flag("--json", options.json, "print one JSON object in place of the table");
}

std::vector<Row> compare(const Options& options, const Case& spheres, const PeerInfo& peer) {
  std::vector<Row> rows;
  if (options.mode != "update") rows.push_back(compare_cold(spheres, peer, options.search, options.protocol));
  if (options.mode != "cold") {
    PeerOptions search = options.search;
    search.skin = options.skin;
    rows.push_back(compare_updates(spheres, peer, search, options.protocol));
  }
  return rows;
}

std::vector<Row> compare_all(const Options& options) {
  std::vector<Row> rows;
  if (!options.json) std::cout << table_head() << std::flush;
  for (const std::string& family : options.families) {
    const int64_t steps = options.mode == "cold" ? 0 : options.steps;
    const Case spheres = make_case(family, options.count, options.seed, steps);
    for (const PeerInfo& peer : peer_table()) {
      if (std::find(options.peers.begin(), options.peers.end(), peer.name) == options.peers.end()) continue;
      for (const Row& row : compare(options, spheres, peer)) {
        if (!options.json) std::cout << table_line(row) << std::flush;
        rows.push_back(row);
      }
    }
  }
  return rows;
}

nlohmann::ordered_json describe(const Options& options) {
  nlohmann::ordered_json libraries = nlohmann::ordered_json::array();
  for (const PeerInfo& peer : peer_table()) {
    libraries.push_back({{"peer", peer.name},
                         {"library", peer.package},
                         {"method", peer.method},
                         {"threads", peer.uses_threads ? options.search.threads : 1}});
  }
  return {{"count", options.count},
          {"seed", options.seed},
          {"threads", options.search.threads},
          {"broadphase", options.search.broadphase},
          {"skin", options.skin},
          {"clock", options.clock},
          {"repeat", options.protocol.cold},
          {"drifts", options.protocol.drifts},
          {"steps", options.steps},
          {"machine", machine()},
          {"peers", libraries}};
}

void print_json(const Options& options, const std::vector<Row>& rows) {
  nlohmann::ordered_json report = describe(options);
  report["rows"] = json_of(rows);
  for (const Summary& s : summarize(rows)) {
    report["summary"].push_back({{"peer", s.peer},
                                 {"mode", s.mode},
                                 {"geometric_mean", s.geometric_mean},
                                 {"worst", s.worst},
                                 {"worst_family", s.worst_family}});
  }
  std::cout << report.dump(2) << "\n";
}

void run(const Options& options) {
  check(options);
  const std::vector<Row> rows = compare_all(options);
  if (options.json) {
    print_json(options, rows);
  } else {
    std::cout << table_foot(summarize(rows));
  }
  if (!options.csv.empty()) write_file(options.csv, csv_of(rows));
  const bool all_equal = std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.equal; });
  if (!all_equal) throw RunError("peers", "pairs differ");
}

}  // namespace

int main(int argc, char** argv) {
  set_up_heap();  // otherwise each search would wait for the system to clear new memory
  CLI::App app("Times our pair search against those of other libraries.", "bench_peers");
  Options options;
  options.families = family_names();
  options.peers = peer_names();
  add_options(app, options);
  return run_command(app, argc, argv, [&] {
    if (options.clock == "cpu") options.protocol.clock = Clock::cpu;
    run(options);
  });
}
