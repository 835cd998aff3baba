// SPDX-License-Identifier: MIT
// The penalty response against LAMMPS on beds of spheres under gravity: the same start, step, stiffness and damping,
// one thread each.
//
//     bench_beds                                      both beds, 10 000 and 100 000 spheres
//     bench_beds --beds dense --count 10000 --csv beds.csv
//     bench_beds --only lammps --keep out/beds        LAMMPS alone; its input, data and log stay
//
// docs/benchmarks.md says what is measured. Exit status: 0 done, 1 energies differ or the run failed, 2 wrong options.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>

#include <nlohmann/json.hpp>

#include "command_line.h"
#include "compare.h"
#include "core/file.h"
#include "measure/machine.h"
#include "report.h"

using namespace ballpit;

namespace {

struct Options {
  std::vector<std::string> beds;
  std::vector<int64_t> counts{10000, 100000};
  uint64_t seed = 1;
  int64_t settle = 16000;
  std::string only = "both";
  std::string clock = "wall";
  std::string lammps = "lmp";
  std::string integrator = "nve/sphere";
  std::string precision = "float";
  std::string our_integrator = "symplectic-euler";
  std::string broadphase = "auto";
  double skin = 0.1;
  std::optional<double> tolerance;
  BedProtocol protocol;
  bool json = false;
  std::string csv;
  std::string keep;
};

std::vector<std::string> bed_names() {
  std::vector<std::string> names;
  for (const BedInfo& bed : beds()) names.emplace_back(bed.name);
  return names;
}

void check(const Options& options) {
  require_names("--beds", options.beds, bed_names());
  for (const int64_t count : options.counts) require_range("--count", count, 1, 10'000'000);
  require_names("--only", {options.only}, {"both", "ours", "lammps"});
  require_names("--clock", {options.clock}, {"wall", "cpu"});
  require_names("--integrator", {options.our_integrator}, {"symplectic-euler", "velocity-verlet"});
  require_names("--lammps-fix", {options.integrator}, {"nve/sphere", "nve"});
  require_range("--repeat", options.protocol.repeat, 1, 1000);
  require_range("--warmup", options.protocol.stretch.warmup, 0, 1'000'000);
  require_range("--steps", options.protocol.stretch.steps, 1, 1'000'000);
  require_range("--settle", options.settle, 0, 1'000'000);
  require(options.skin >= 0 && options.skin <= 10, "--skin", std::to_string(options.skin), "0 to 10");
  const double skin = options.protocol.lammps.skin;
  require(skin > 0 && skin <= 10, "--lammps-skin", std::to_string(skin), "above 0, to 10");
}

void add_options(CLI::App& app, Options& options) {
  const auto add = [&app](const char* name, auto& value, const char* type, const std::string& help) {
    return app.add_option(name, value, help)->type_name(type);
  };
  app.option_defaults()->always_capture_default();
  add("--beds", options.beds, "NAMES", "loose, dense")->delimiter(',');
  add("--count", options.counts, "NUMBERS", "spheres")->delimiter(',');
  add("--seed", options.seed, "N", "start of the random numbers");
  add("--repeat", options.protocol.repeat, "N", "turns of ours and LAMMPS");
  add("--warmup", options.protocol.stretch.warmup, "N", "steps before the clock starts, in each turn");
  add("--steps", options.protocol.stretch.steps, "N", "steps timed, in each turn");
  add("--settle", options.settle, "N",
      "steps of ours in which the dense bed comes to rest, before all turns; a quarter for the loose one");
  add("--only", options.only, "WHOM", "both, ours, lammps");
  add("--clock", options.clock, "NAME", "wall, or cpu: time of the processes, on a busy machine");
  add("--broadphase", options.broadphase, "NAME", "ours");
  add("--skin", options.skin, "NUMBER", "ours, as a fraction of the radius");
  add("--integrator", options.our_integrator, "NAME", "ours: symplectic-euler, velocity-verlet");
  add("--precision", options.precision, "NAME", "ours: float, double");
  add("--lammps", options.lammps, "PROGRAM", "LAMMPS: a path, or a name on PATH");
  add("--lammps-skin", options.protocol.lammps.skin, "NUMBER", "LAMMPS' skin, as a fraction of the radius");
  add("--lammps-fix", options.integrator, "NAME", "nve/sphere, or nve: without rotation");
  app.add_flag("--lammps-newton", options.protocol.lammps.newton, "newton on in place of off");
  app.add_option(
         "--tolerance", options.tolerance,
         "by which kinetic energies may differ at the end, as a fraction; unless told 0.005 in float, 0.001 in double")
      ->type_name("NUMBER");
  add("--keep", options.keep, "FOLDER", "keep LAMMPS' input, data and log there");
  add("--csv", options.csv, "FILE", "write the rows to a file as well");
  app.add_flag("--json", options.json, "print one JSON object in place of the table");
}

/// A folder for the files of LAMMPS. It is removed at the end unless the user has named it.
class Folder {
 public:
  explicit Folder(const std::string& keep) : path_(keep), is_kept_(!keep.empty()) {
    if (is_kept_) return;
    std::string name = (std::filesystem::temp_directory_path() / "bench_beds_XXXXXX").string();
    if (!mkdtemp(name.data())) throw RunError(name, "cannot make a folder like this");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    if (!is_kept_) std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path of(const Bed& bed) const {
    return path_ / (bed.name + "_" + std::to_string(bed.scene.bodies.size()));
  }

 private:
  std::filesystem::path path_;
  bool is_kept_;
};

/// Empty if it is not wanted or missing. Reports if it is missing.
std::optional<Lammps> find_lammps(const Options& options) {
  if (options.only == "ours") return std::nullopt;
  std::optional<Lammps> lammps = Lammps::find(options.lammps);
  if (lammps) return lammps;
  const std::string absent = "no program " + options.lammps + " (Debian package lammps)";
  if (options.only == "lammps") throw RunError("LAMMPS", absent);
  std::cerr << "bench_beds: LAMMPS: " << absent << "; Ballpit runs alone\n";
  return std::nullopt;
}

BedProtocol protocol_of(const Options& options) {
  BedProtocol protocol = options.protocol;
  protocol.clock = options.clock == "cpu" ? BedClock::cpu : BedClock::wall;
  protocol.runs_ours = options.only != "lammps";
  protocol.lammps.rotates = options.integrator == "nve/sphere";
  apply_setting(protocol.settings, "broadphase", options.broadphase, "--broadphase");
  apply_setting(protocol.settings, "integrator", options.our_integrator, "--integrator");
  apply_setting(protocol.settings, "precision", options.precision, "--precision");
  protocol.settings.skin = options.skin;
  return protocol;
}

std::vector<BedRow> compare_all(const Options& options, std::optional<Lammps>& lammps) {
  const Folder folder(options.keep);
  BedProtocol protocol = protocol_of(options);
  std::vector<BedRow> rows;
  if (!options.json) std::cout << table_head() << std::flush;
  for (const std::string& name : options.beds) {
    for (const int64_t count : options.counts) {
      const Bed bed = make_bed(name, count, options.seed, options.settle);
      protocol.settings.dt = bed.dt;
      rows.push_back(compare_bed(bed, lammps, protocol, folder.of(bed)));
      if (!options.json) std::cout << table_line(rows.back()) << std::flush;
    }
  }
  return rows;
}

nlohmann::ordered_json describe(const Options& options, const std::optional<Lammps>& lammps) {
  nlohmann::ordered_json text{{"seed", options.seed},
                              {"repeat", options.protocol.repeat},
                              {"warmup", options.protocol.stretch.warmup},
                              {"steps", options.protocol.stretch.steps},
                              {"threads", 1},
                              {"clock", options.clock},
                              {"broadphase", options.broadphase},
                              {"skin", options.skin},
                              {"precision", options.precision},
                              {"integrator", options.our_integrator},
                              {"machine", describe_machine()}};
  if (lammps) {
    text["lammps"] = {{"program", lammps->path()},
                      {"version", lammps->version()},
                      {"skin", options.protocol.lammps.skin},
                      {"fix", options.integrator},
                      {"newton", options.protocol.lammps.newton}};
  }
  return text;
}

void print_foot(const Options& options, const std::optional<Lammps>& lammps) {
  const nlohmann::ordered_json machine = describe_machine();
  std::cout << "\n"
            << machine["cpu"].get<std::string>() << ", " << machine["compiler"].get<std::string>() << ", "
            << machine["build_type"].get<std::string>() << ", one thread, clock " << options.clock << "; ours in "
            << options.precision << ", " << options.our_integrator << ", skin " << options.skin << "\n";
  if (!lammps) return;
  std::cout << "LAMMPS " << lammps->version() << ", fix " << options.integrator << ", skin "
            << options.protocol.lammps.skin << "\n";
}

void run(const Options& options) {
  check(options);
  std::optional<Lammps> lammps = find_lammps(options);
  const std::vector<BedRow> rows = compare_all(options, lammps);
  if (options.json) {
    nlohmann::ordered_json report = describe(options, lammps);
    report["rows"] = json_of(rows);
    std::cout << report.dump(2) << "\n";
  } else {
    print_foot(options, lammps);
  }
  if (!options.csv.empty()) write_file(options.csv, csv_of(rows, options.protocol.stretch));
  // A dense bed that is nearly at rest amplifies rounding: our own two precisions differ by 0.001 there.
  const double tolerance = options.tolerance.value_or(options.precision == "float" ? 5e-3 : 1e-3);
  for (const BedRow& row : rows) {
    if (!row.has_both() || row.energy_difference() <= tolerance) continue;
    throw RunError(row.bed + " of " + std::to_string(row.count) + " spheres", "kinetic energies differ");
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the penalty response against LAMMPS on beds of spheres.", "bench_beds");
  Options options;
  options.beds = bed_names();
  options.protocol.settings = bed_settings(0);
  add_options(app, options);
  return run_command(app, argc, argv, [&] { run(options); });
}
