// SPDX-License-Identifier: MIT
// ballpit lab: experiments that measure what methods cost and what they get right; tables, charts, one report.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "cli/options.h"
#include "cli/progress.h"
#include "core/file.h"
#include "core/interrupt.h"
#include "core/language.h"
#include "lab/charts/gnuplot.h"
#include "lab/report/experiment.h"
#include "lab/report/report.h"
#include "measure/machine.h"
#include "render/painter.h"
#include "show/notes.h"

namespace ballpit {

namespace {

double seconds_of(const Experiment& experiment, bool is_quick) {
  return is_quick ? experiment.quick_seconds : experiment.full_seconds;
}

/// "40 s", "12 min", "1.5 h"
std::string duration_text(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 90 * 60) return fmt::format("{:.0f} min", std::ceil(seconds / 60));
  return fmt::format("{:.1f} h", std::ceil(seconds / 360) / 10);
}

/// The bar over all experiments. The time left is predicted from the times in their table, scaled by the pace of this
/// machine so far. Measurements taken from the cache count as done but do not count for the pace.
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

  void count(bool was_kept) {
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
  double expected_ = 0, spent_ = 0;                   // [s] of what was measured: by the table, and measured
  std::string name_;
  Clock::time_point last_;
};

class LabCommand {
 public:
  void add_options(CommandOptions& command) {
    command.add({.name = "EXPERIMENT",
                 .type = "NAME",
                 .help = "all, or one of " + join(names_in(experiments())),
                 .is_required = true},
                [this](const std::string& text) { choose(text); });
    command.add_path({.name = "--out",
                      .type = "DIR",
                      .help = "folder for tables, charts, the report, and what was measured",
                      .is_required = true},
                     out_);
    command.add_flag("--quick", is_quick_, "fewer and smaller cases, each experiment in less than 90 seconds");
    add_language(command);
    command.add_number({"--seed", "N", "start of the random numbers"}, seed_, Range{uint64_t{0}, uint64_t{INT64_MAX}});
  }

  void run() {
    folder_ = out_;
    check_outputs();
    make_folder(folder_ / "cache");
    catch_interrupts();
    announce();
    const std::vector<ReportSection> sections = run_all();
    for (const ReportSection& section : sections) {
      std::cout << section.experiment->text().title << ": " << section.findings.answer << "\n";
    }
    std::cout << "Report: " << (folder_ / "report.html").string() << "\n";
  }

 private:
  void choose(const std::string& name) {
    if (name != "all") {
      chosen_.push_back(&find_experiment(name));
      return;
    }
    for (const Experiment& experiment : experiments()) chosen_.push_back(&experiment);
  }

  /// The files and folders of the run whose names are known.
  void check_outputs() const {
    const std::filesystem::path cache = folder_ / "cache";
    check_output_folder(cache);
    for (const Experiment* experiment : chosen_) check_output_folder(folder_ / experiment->name);
    if (!std::filesystem::exists(folder_)) return;
    for (const char* report : {"report.html", "report.md"}) check_output(folder_ / report);
    if (!std::filesystem::exists(cache)) return;
    for (const Experiment* experiment : chosen_) check_output(cache / (std::string(experiment->name) + ".csv"));
  }

  /// Before anything is measured: how long it will take, and what will be missing.
  void announce() {
    double seconds = 0;
    for (const Experiment* experiment : chosen_) seconds += seconds_of(*experiment, is_quick_);
    note("lab", fmt::format("{}, about {} on two cores, less what {} already holds",
                            counted(static_cast<int64_t>(chosen_.size()), "experiment"), duration_text(seconds),
                            (folder_ / "cache").string()));
    if (!gnuplot_.empty()) return;
    const std::string lack =
        "No charts: gnuplot is not on the PATH (Debian: gnuplot-nox). The same command draws them later, without "
        "measuring again.";
    lack_ = translated(lack);
    print_warnings({lack});
  }

  /// Writes the report after each experiment, so that an interrupted run leaves what it has.
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
    Lab lab({.is_quick = is_quick_,
             .seed = seed_,
             .cache = folder_ / "cache" / (std::string(experiment.name) + ".csv"),
             .tell = [&](bool was_kept) { progress.count(was_kept); },
             .name = std::string(experiment.name),
             .stop = was_interrupted});
    ReportSection section{&experiment, experiment.run(lab), {}, command_of(experiment)};
    write_tables(section, lab.load());
    draw_charts(section);
    return section;
  }

  void write_tables(const ReportSection& section, double load) const {
    const std::filesystem::path folder = folder_ / section.experiment->name;
    make_folder(folder);
    std::vector<std::string> comments{section.command};
    for (const auto& [name, value] : circumstances()) comments.push_back(name + ": " + value);
    if (load > 0) comments.push_back("load average while timing, own threads included: up to " + three_digits(load));
    for (const Table& table : section.findings.tables) {
      write_file(folder / (table.name + ".csv"), csv_of(table, comments));
    }
  }

  void draw_charts(ReportSection& section) const {
    if (gnuplot_.empty()) return;
    const std::filesystem::path folder = folder_ / section.experiment->name;
    for (const Chart& found : section.findings.charts) {
      const Chart chart = in_language_set(found);
      section.charts.push_back(
          {chart.name, chart.title, draw_svg(chart, Ground::light, gnuplot_), draw_svg(chart, Ground::dark, gnuplot_)});
      write_file(folder / (chart.name + ".svg"), section.charts.back().light);
      write_file(folder / (chart.name + "-dark.svg"), section.charts.back().dark);
    }
  }

  std::string command_of(const Experiment& experiment) const {
    return fmt::format("ballpit lab {} --out {}{}{}{}", experiment.name, out_, is_quick_ ? " --quick" : "",
                       language() == Language::english ? "" : fmt::format(" --lang {}", name_of(language())),
                       seed_ == 1 ? "" : fmt::format(" --seed {}", seed_));
  }

  std::vector<Circumstance> circumstances() const {
    return {{"machine", machine_line()}, {"preset", is_quick_ ? "quick" : "full"}, {"seed", std::to_string(seed_)}};
  }

  std::string out_;
  uint64_t seed_ = 1;
  bool is_quick_ = false;
  std::vector<const Experiment*> chosen_;
  std::filesystem::path folder_;
  std::string gnuplot_ = gnuplot_path();
  std::string lack_;
};

}  // namespace

std::function<void()> make_lab_command(CommandOptions& options) { return make_command<LabCommand>(options); }

}  // namespace ballpit
