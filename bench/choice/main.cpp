// SPDX-License-Identifier: MIT
// `choose` on held-out random scenes: are its tolerances held in a full run, and what does it cost against the cheapest of a
// wide grid of options (src/lab/measure/regret.h)?
//
//     bench_choice --scenes 200 --from 1000 --csv regret.csv
//     bench_choice --scenes 1 --from 1042 --write out      the scene as a file, for a look
//
// Exit status: 0 all hold, 1 some do not or the run failed, 2 wrong options.
#include <algorithm>
#include <cmath>
#include <optional>

#include "command_line.h"
#include "core/file.h"
#include "core/numbers.h"
#include "lab/charts/table.h"
#include "lab/measure/held_out.h"
#include "lab/measure/regret.h"
#include "measure/machine.h"
#include "measure/statistics.h"
#include "scene/read_scene.h"

using namespace ballpit;

namespace {

struct Options {
  int64_t scenes = 14;
  uint64_t from = 1;
  double budget = 5;
  std::string csv, write;
};

Table table_of(const std::vector<std::pair<uint64_t, Judged>>& all) {
  Table table{"regret",
              {"seed", "family", "spheres", "holds", "regret", "cost [s]", "cheapest [s]", "method", "cheapest method",
               "chosen in [s]", "why"}};
  for (const auto& [seed, j] : all) {
    table.add_row(static_cast<double>(seed), j.family, j.count,
                  std::string(!j.has_choice ? "refused"
                              : j.holds     ? "yes"
                                            : "no"),
                  j.regret(), j.cost, j.best_cost, j.method, j.best_method, j.chosen_in, j.why);
  }
  return table;
}

void run(const Options& options) {
  require_range("--scenes", options.scenes, 1, 100'000);
  std::vector<std::pair<uint64_t, Judged>> all;
  std::vector<double> regrets;
  int broken = 0, refused = 0;
  if (!options.write.empty()) make_folder(options.write);
  for (uint64_t seed = options.from; seed < options.from + static_cast<uint64_t>(options.scenes); ++seed) {
    const HeldOutScene held_out = held_out_scene(seed, drawn_units(seed));
    const std::string name = fmt::format("{}-{}.toml", held_out.family, seed);
    if (!options.write.empty()) write_file(std::filesystem::path(options.write) / name, held_out.text);
    const Judged judged = judge(held_out.family, parse_scene(held_out.text, name), options.budget);
    broken += judged.has_choice && !judged.holds;
    refused += !judged.has_choice;
    regrets.push_back(judged.regret());
    all.emplace_back(seed, judged);
    fmt::print("{:>6} {:<8} {:>5} spheres  {:<8} regret {:>6.2f}  {:>9} s of {:>9} s  {} ({})  in {:.1f} s  {}\n", seed,
               judged.family, judged.count,
               !judged.has_choice ? "refused"
               : judged.holds     ? "holds"
                                  : "BROKEN",
               judged.regret(), three_digits(judged.cost), three_digits(judged.best_cost), judged.method,
               judged.best_method, judged.chosen_in, judged.why);
    std::fflush(stdout);
    if (!options.csv.empty()) write_file(options.csv, csv_of(table_of(all), {machine_line()}));
  }
  fmt::print("{} scenes: {} broken, {} refused; regret: median {:.2f}, worst {:.2f}\n", all.size(), broken, refused,
             spread_of(regrets).median, *std::ranges::max_element(regrets));
  if (broken > 0) throw std::runtime_error(fmt::format("{} of {} choices do not hold", broken, all.size()));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Judges `ballpit choose` on held-out random scenes.", "bench_choice");
  Options options;
  app.option_defaults()->always_capture_default();
  app.add_option("--scenes", options.scenes, "how many");
  app.add_option("--from", options.from, "seed of the first");
  app.add_option("--budget", options.budget, "[s] for the pilots of a choice");
  app.add_option("--csv", options.csv, "write the table there");
  app.add_option("--write", options.write, "write the scenes there");
  return run_command(app, argc, argv, [&] { run(options); });
}
