// SPDX-License-Identifier: MIT
// ballpit lab: experiments that measure what methods cost and what they get right; tables, charts, one report.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "core/error.h"
#include "core/file.h"
#include "core/interrupt.h"
#include "core/numbers.h"
#include "lab/charts/gnuplot.h"
#include "lab/report/experiment.h"
#include "lab/report/report.h"
#include "measure/machine.h"
#include "show/notes.h"

namespace ballpit {

namespace {

double seconds_of(const Experiment& experiment, bool is_quick) {
  return is_quick ? experiment.quick_seconds : experiment.full_seconds;
}

/// "40 s", "12 min", "1.5 h"
std::string duration_text(double seconds) {
  if (seconds < 90) return std::to_string(static_cast<int>(std::ceil(seconds))) + " s";
  if (seconds < 90 * 60) return std::to_string(static_cast<int>(std::ceil(seconds / 60))) + " min";
  return std::to_string(static_cast<int>(std::ceil(seconds / 360)) / 10.0).substr(0, 3) + " h";
}

/// The bar over all experiments. What is left is their table's times, as this machine has kept to them so far;
/// what the cache held counts as done, and says nothing about the machine.
class LabProgress {
 public:
  LabProgress(const std::vector<const Experiment*>& chosen, bool is_quick) : is_quick_(is_quick) {
    for (const Experiment* experiment : chosen) total_ += seconds_of(*experiment, is_quick);
  }

  void begin(const Experiment& experiment) {
    part_ = seconds_of(experiment, is_quick_) / static_cast<double>(experiment.measurements(is_quick_));
    end_ = done_ + seconds_of(experiment, is_quick_);
    name_ = experiment.name;
    last_ = Clock::now();
    show();
  }

  void tell(bool was_kept) {
    const Clock::time_point now = Clock::now();
    done_ = std::min(done_ + part_, end_);
    if (!was_kept) {
      expected_ += part_;
      spent_ += std::chrono::duration<double>(now - last_).count();
    }
    last_ = now;
    show();
  }

  void end() { done_ = end_; }

 private:
  using Clock = std::chrono::steady_clock;

  void show() {
    constexpr double kTrusted = 5;  // [s] after which the machine's own pace counts
    const double pace = spent_ > kTrusted ? spent_ / expected_ : 1;
    bar_.show(done_ / total_, name_ + ", about " + duration_text((total_ - done_) * pace) + " left");
  }

  ProgressBar bar_;
  bool is_quick_;
  double total_ = 0, done_ = 0, end_ = 0, part_ = 0;  // [s] by the table
  double expected_ = 0, spent_ = 0;                   // [s] of what was measured: by the table, and in truth
  std::string name_;
  Clock::time_point last_;
};

class LabCommand final : public Command {
 public:
  void add_options(CommandOptions& command) override {
    command.add_option("EXPERIMENT", name_, "all, or one of " + join(names()))->type_name("NAME")->required();
    command.add_option("--out", out_, "folder for tables, charts, the report, and what was measured")
        ->type_name("DIR")
        ->required();
    command.add_flag("--quick", is_quick_, "fewer and smaller cases, each experiment in less than 90 seconds");
    command.add_option("--seed", seed_, "start of the random numbers")->type_name("N")->shows_default();
  }

  void run() override {
    if (name_ == "all") {
      for (const Experiment& experiment : experiments()) chosen_.push_back(&experiment);
    } else {
      chosen_.push_back(&find_experiment(name_));
    }
    folder_ = parse_path("--out", out_);
    seed_number_ = static_cast<uint64_t>(parse_integer("--seed", seed_, 0, INT64_MAX));
    check_outputs();
    make_folder(folder_ / "cache");
    catch_interrupts();
    announce();
    const std::vector<ReportSection> sections = run_all();
    for (const ReportSection& section : sections) {
      std::cout << section.experiment->title << ": " << section.findings.answer << "\n";
    }
    std::cout << "Report: " << (folder_ / "report.html").string() << "\n";
  }

 private:
  /// What the run is to leave, as far as it is known by name.
  void check_outputs() const {
    const std::filesystem::path cache = folder_ / "cache";
    check_output_folder(cache);
    for (const Experiment* experiment : chosen_) check_output_folder(folder_ / experiment->name);
    if (!std::filesystem::exists(folder_)) return;
    for (const char* report : {"report.html", "report.md"}) check_output(folder_ / report);
    if (!std::filesystem::exists(cache)) return;
    for (const Experiment* experiment : chosen_) check_output(cache / (std::string(experiment->name) + ".csv"));
  }

  static std::vector<std::string_view> names() {
    std::vector<std::string_view> result;
    for (const Experiment& experiment : experiments()) result.push_back(experiment.name);
    return result;
  }

  /// Before anything is measured: how long it takes, and what will be missing.
  void announce() {
    double seconds = 0;
    for (const Experiment* experiment : chosen_) seconds += seconds_of(*experiment, is_quick_);
    note("lab", std::to_string(chosen_.size()) + (chosen_.size() == 1 ? " experiment" : " experiments") + ", about " +
                    duration_text(seconds) + " on two cores, less what " + (folder_ / "cache").string() +
                    " already holds");
    if (!gnuplot_.empty()) return;
    lack_ =
        "No charts: gnuplot is not on the PATH (Debian: gnuplot-nox). The same command draws them later, without "
        "measuring again.";
    tell_notes({lack_});
  }

  /// The report grows with each experiment: one that is interrupted leaves those before it.
  std::vector<ReportSection> run_all() {
    LabProgress progress(chosen_, is_quick_);
    std::vector<ReportSection> sections;
    for (const Experiment* experiment : chosen_) {
      progress.begin(*experiment);
      try {
        sections.push_back(run_one(*experiment, progress));
        write_file(folder_ / "report.html", report_html(sections, circumstances(), lack_));
        write_file(folder_ / "report.md", report_markdown(sections, circumstances(), lack_));
      } catch (const RunError& error) {
        throw error.inside(experiment->name);
      }
      progress.end();
    }
    return sections;
  }

  ReportSection run_one(const Experiment& experiment, LabProgress& progress) {
    LabOptions options;
    options.is_quick = is_quick_;
    options.seed = seed_number_;
    options.cache = folder_ / "cache" / (std::string(experiment.name) + ".csv");
    options.tell = [&](bool was_kept) { progress.tell(was_kept); };
    options.name = experiment.name;
    options.stop = was_interrupted;
    Lab lab(options);
    ReportSection section{&experiment, experiment.run(lab), {}, command_of(experiment)};
    write_tables(section, lab.load());
    draw_charts(section);
    return section;
  }

  void write_tables(const ReportSection& section, double load) const {
    const std::filesystem::path folder = folder_ / section.experiment->name;
    make_folder(folder);
    std::vector<std::string> comments = circumstances();
    comments.insert(comments.begin(), section.command);
    if (load > 0) comments.push_back("load average while timing, own threads included: up to " + three_digits(load));
    for (const Table& table : section.findings.tables) {
      write_file(folder / (table.name + ".csv"), csv_of(table, comments));
    }
  }

  void draw_charts(ReportSection& section) const {
    if (gnuplot_.empty()) return;
    const std::filesystem::path folder = folder_ / section.experiment->name;
    for (const Chart& chart : section.findings.charts) {
      section.charts.push_back(
          {chart.name, chart.title, draw_svg(chart, Ground::light, gnuplot_), draw_svg(chart, Ground::dark, gnuplot_)});
      write_file(folder / (chart.name + ".svg"), section.charts.back().light);
      write_file(folder / (chart.name + "-dark.svg"), section.charts.back().dark);
    }
  }

  std::string command_of(const Experiment& experiment) const {
    return "ballpit lab " + std::string(experiment.name) + " --out " + out_ + (is_quick_ ? " --quick" : "") +
           (seed_ == "1" ? "" : " --seed " + seed_);
  }

  std::vector<std::string> circumstances() const {
    return {"machine: " + machine_line(), std::string("preset: ") + (is_quick_ ? "quick" : "full"), "seed: " + seed_};
  }

  std::string name_, out_;
  std::string seed_ = "1";
  uint64_t seed_number_ = 1;
  bool is_quick_ = false;
  std::vector<const Experiment*> chosen_;
  std::filesystem::path folder_;
  std::string gnuplot_ = gnuplot_path();
  std::string lack_;
};

}  // namespace

std::unique_ptr<Command> make_lab_command() { return std::make_unique<LabCommand>(); }

}  // namespace ballpit
