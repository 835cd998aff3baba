// SPDX-License-Identifier: MIT
// The table of experiments, the resuming of an interrupted one, and the report.
#include <filesystem>
#include <regex>
#include <set>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "lab/charts/gnuplot.h"
#include "lab/experiments/accuracy.h"
#include "lab/report/experiment.h"
#include "lab/report/report.h"
#include "tests/support/in_german.h"

using namespace ballpit;
using Catch::Contains;

namespace {

/// All tables as they would be written.
std::string tables_of(const Findings& findings) {
  std::string text = findings.answer + findings.see;
  for (const Table& table : findings.tables) text += table.name + csv_of(table, {});
  return text;
}

}  // namespace

TEST_CASE("every experiment has a unique name, a question, and times within the limits") {
  std::set<std::string_view> names;
  double quick = 0;
  for (const Experiment& experiment : experiments()) {
    INFO(experiment.name);
    CHECK(names.insert(experiment.name).second);
    CHECK(experiment.name != "all");
    CHECK(experiment.text().question.back() == '?');
    CHECK(experiment.quick_seconds <= 90);
    CHECK(experiment.full_seconds <= 3600);
    CHECK(experiment.measurements(true) > 0);
    CHECK(experiment.measurements(false) >= experiment.measurements(true));
    quick += experiment.quick_seconds;
  }
  CHECK(quick <= 12 * 60);
}

TEST_CASE("every {name} in the text of an experiment is a value that is measured") {
  std::string sources;
  for (const auto& file : std::filesystem::directory_iterator(BALLPIT_SOURCE_DIR "/src/lab/experiments")) {
    sources += read_file(file.path());
  }
  const std::regex place("\\{([^}]*)\\}");
  const auto names_in = [&](const std::string& text) {
    std::multiset<std::string> names;
    for (std::sregex_iterator match(text.begin(), text.end(), place), end; match != end; ++match) {
      names.insert((*match)[1]);
    }
    return names;
  };
  for (const Experiment& experiment : experiments()) {
    const ExperimentText english = experiment.text();
    REQUIRE_FALSE(english.see.empty());
    for (const std::string& name : names_in(english.answer + english.see)) {
      CHECK_THAT(sources, Contains("{\"" + name + "\", "));
    }
    const InGerman in_german;
    const ExperimentText german = experiment.text();
    CHECK(german.title != english.title);
    CHECK(german.question.back() == '?');
    CHECK(names_in(german.answer) == names_in(english.answer));
    CHECK(names_in(german.see) == names_in(english.see));
  }
}

TEST_CASE("docs/lab.md lists every experiment with its question") {
  const std::string page = read_file(BALLPIT_SOURCE_DIR "/docs/lab.md");
  for (const Experiment& experiment : experiments()) {
    CHECK_THAT(page, Contains("| `" + std::string(experiment.name) + "` | " + experiment.text().question + " |"));
  }
}

TEST_CASE("docs/lab.md lists every scene of work-precision") {
  const std::string page = read_file(BALLPIT_SOURCE_DIR "/docs/lab.md");
  for (const Task& task : tasks()) CHECK_THAT(page, Contains("`" + task.name + "`"));
}

TEST_CASE("an interrupted experiment continues where it stopped, with the same tables") {
  const Experiment& experiment = find_experiment("divergence");
  const std::filesystem::path cache =
      std::filesystem::temp_directory_path() / ("ballpit-resume-" + std::to_string(::getpid()) + ".csv");
  std::filesystem::remove(cache);
  LabOptions options;
  options.is_quick = true;
  Lab whole(options);
  const std::string expected = tables_of(experiment.run(whole));
  CHECK(whole.asked() == experiment.measurements(true));
  CHECK(whole.measured() == whole.asked());

  options.cache = cache;
  int done = 0;
  LabOptions interrupted = options;
  interrupted.tell = [&](bool) { ++done; };
  interrupted.stop = [&] { return done == 5; };
  Lab first(interrupted);
  CHECK_THROWS_AS(experiment.run(first), RunError);
  CHECK(first.measured() == 5);
  Lab second(options);
  CHECK(tables_of(experiment.run(second)) == expected);
  CHECK(second.measured() == experiment.measurements(true) - 5);
  Lab third(options);
  CHECK(tables_of(experiment.run(third)) == expected);
  CHECK(third.measured() == 0);
  std::filesystem::remove(cache);
}

TEST_CASE("the report contains question, answer, charts, shown tables and command, and nothing from other sites") {
  const Experiment& experiment = find_experiment("divergence");
  LabOptions options;
  options.is_quick = true;
  Lab lab(options);
  Findings findings = experiment.run(lab);
  findings.answer += " <&>";
  const ReportSection section{&experiment,
                              findings,
                              {{"work", "Work", "<svg>light</svg>", "<svg>dark</svg>"}},
                              "ballpit lab divergence --out here --quick"};
  const std::string page = report_html({section}, {{"machine", "some"}}, "No charts: because");
  for (const std::string& text : {experiment.text().question, html_text(findings.answer), html_text(findings.see),
                                  section.command, std::string("machine: some"), std::string("No charts: because"),
                                  svg_address("<svg>light</svg>"), svg_address("<svg>dark</svg>"),
                                  std::string("href=\"divergence/work.csv\""), std::string("SIMD efficiency [%]")}) {
    CHECK_THAT(page, Contains(text));
  }
  CHECK_THAT(page, !Contains("http") && !Contains("<script") && !Contains(" <&>"));
  const std::string markdown = report_markdown({section}, {{"machine", "some"}}, "No charts: because");
  for (const std::string& text :
       {experiment.text().question, std::string(" \\<\\&>**"), section.command, std::string("- machine: some\n"),
        std::string("**No charts: because**"), std::string("![Work](divergence/work.svg)"),
        std::string("| SIMD efficiency \\[%\\] |")}) {
    CHECK_THAT(markdown, Contains(text));
  }
}

TEST_CASE("docs/lab contains the results of all full experiments, with their charts") {
  const std::string page = read_file(BALLPIT_SOURCE_DIR "/docs/lab/README.md");
  CHECK_THAT(page, Contains("preset: full") && !Contains("No charts"));
  for (const Experiment& experiment : experiments()) {
    CHECK_THAT(page, Contains("## " + experiment.text().title + "\n"));
    CHECK_THAT(page, Contains("](" + std::string(experiment.name) + "/"));
  }
  for (const Task& task : tasks()) CHECK_THAT(page, Contains("](work-precision/" + task.name + ".svg)"));
  const std::filesystem::path folder(BALLPIT_SOURCE_DIR "/docs/lab");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".svg") continue;
    CHECK_THAT(page, Contains("](" + std::filesystem::relative(entry.path(), folder).string() + ")"));
  }
}

TEST_CASE("a picture in the page is encoded in base64") {
  CHECK(svg_address("Man") == "data:image/svg+xml;base64,TWFu");
  CHECK(svg_address("Ma") == "data:image/svg+xml;base64,TWE=");
  CHECK(svg_address("M") == "data:image/svg+xml;base64,TQ==");
}
