// SPDX-License-Identifier: MIT
// ballpit lab, as a user runs it: what it writes, and what it says where it cannot.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <catch2/catch.hpp>

#include "lab/report/experiment.h"
#include "tests/support/run_program.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// The quickest of all.
Outcome run_divergence(const std::string& out) { return run_program({"lab", "divergence", "--quick", "--out", out}); }

}  // namespace

TEST_CASE("lab writes tables with the machine, charts on both grounds, and a report with all of it") {
  const Scratch scratch;
  const Outcome outcome = run_divergence(scratch / "out");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.err, Contains("1 experiment, about "));
  CHECK_THAT(outcome.out, Contains("Work per thread: ") && Contains("Report: "));
  const std::string table = read_text(scratch / "out/divergence/work.csv");
  CHECK_THAT(table, Contains("# machine: ") && Contains(" cores; ") && Contains("# preset: quick\n# seed: 1\n"));
  CHECK_THAT(table, Contains("\narrangement,broad phase,"));
  for (const char* picture : {"work.svg", "work-dark.svg"}) {
    CHECK_THAT(read_text(scratch / ("out/divergence/" + std::string(picture))), Contains("</svg>"));
  }
  CHECK_THAT(read_text(scratch / "out/report.html"), Contains("Work per thread") && Contains("data:image/svg+xml"));
  CHECK_THAT(read_text(scratch / "out/report.md"), Contains("](divergence/work.svg)"));
  for (const auto& entry : fs::recursive_directory_iterator(scratch.path())) CHECK(entry.path().extension() != ".part");
}

TEST_CASE("what is measured already is not measured again, and everything comes out the same") {
  const Scratch scratch;
  REQUIRE(run_divergence(scratch / "out").status == 0);
  const std::string cache = read_text(scratch / "out/cache/divergence.csv");
  const std::string report = read_text(scratch / "out/report.html");
  REQUIRE(run_divergence(scratch / "out").status == 0);
  CHECK(read_text(scratch / "out/cache/divergence.csv") == cache);
  CHECK(read_text(scratch / "out/report.html") == report);
}

TEST_CASE("another seed is another measurement") {
  const Scratch scratch;
  REQUIRE(run_divergence(scratch / "out").status == 0);
  const std::string table = read_text(scratch / "out/divergence/work.csv");
  REQUIRE(run_program({"lab", "divergence", "--quick", "--seed", "2", "--out", scratch / "out"}).status == 0);
  CHECK(read_text(scratch / "out/divergence/work.csv") != table);
  CHECK_THAT(read_text(scratch / "out/divergence/work.csv"), Contains("--seed 2") && Contains("# seed: 2"));
}

TEST_CASE("without gnuplot there are tables and a report, and the lack is said") {
  const Scratch scratch;
  {
    const Variable path("PATH", "");
    const Outcome outcome = run_divergence(scratch / "out");
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.err, Contains("warning: No charts: gnuplot is not on the PATH (Debian: gnuplot-nox)"));
  }
  CHECK(fs::exists(scratch / "out/divergence/work.csv"));
  CHECK_FALSE(fs::exists(scratch / "out/divergence/work.svg"));
  CHECK_THAT(read_text(scratch / "out/report.html"), Contains("No charts: gnuplot") && !Contains("<img"));
  const std::string cache = read_text(scratch / "out/cache/divergence.csv");
  REQUIRE(run_divergence(scratch / "out").status == 0);
  CHECK(fs::exists(scratch / "out/divergence/work.svg"));
  CHECK(read_text(scratch / "out/cache/divergence.csv") == cache);
}

TEST_CASE("a gnuplot that fails is an error with what it said") {
  const Scratch scratch;
  write_text(scratch / "gnuplot", "#!/bin/sh\necho out of ink >&2\nexit 1\n");
  fs::permissions(scratch / "gnuplot", fs::perms::owner_all);
  const Variable path("PATH", scratch.path().string());
  const Outcome outcome = run_divergence(scratch / "out");
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("divergence: ") && Contains("failed on chart work: out of ink"));
}

TEST_CASE("wrong use of lab is refused with what is allowed") {
  const Scratch scratch;
  const Outcome unknown = run_program({"lab", "alchemy", "--out", scratch / "out"});
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.err, Contains("EXPERIMENT: found alchemy, allowed all, "));
  for (const Experiment& experiment : experiments()) CHECK_THAT(unknown.err, Contains(std::string(experiment.name)));
  CHECK(run_program({"lab", "divergence"}).status == 2);
  CHECK(run_program({"lab", "--out", scratch / "out"}).status == 2);
  CHECK(run_program({"lab", "divergence", "--out", ""}).status == 2);
  CHECK(run_program({"lab", "divergence", "--out", scratch / "out", "--seed", "-1"}).status == 2);
  CHECK_FALSE(fs::exists(scratch / "out"));
}

TEST_CASE("a folder that cannot be made or written is reported before anything is measured") {
  const Scratch scratch;
  write_text(scratch / "file", "");
  const Outcome blocked = run_divergence(scratch / "file");
  CHECK(blocked.status == 1);
  CHECK_THAT(blocked.err, Contains("file/cache: cannot make the folder: "));
  fs::create_directories(scratch / "out/cache/divergence.csv");
  const Outcome unwritable = run_divergence(scratch / "out");
  CHECK(unwritable.status == 1);
  CHECK_THAT(unwritable.err, Contains("divergence.csv: cannot write: "));
}

TEST_CASE("a full disk is named, and what was measured before is not lost") {
  const Scratch scratch;
  REQUIRE(run_divergence(scratch / "whole").status == 0);
  const std::string whole = read_text(scratch / "whole/cache/divergence.csv");
  Circumstances small;
  small.file_size = whole.size() / 2;
  const Outcome outcome = run_program({"lab", "divergence", "--quick", "--out", scratch / "out"}, small);
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("divergence.csv: cannot write: "));
  REQUIRE(run_divergence(scratch / "out").status == 0);
  CHECK(read_text(scratch / "out/cache/divergence.csv") == whole);
}

TEST_CASE("an interrupted lab keeps what it measured, and the same command goes on from there") {
  const Scratch scratch;
  const std::vector<std::string> command{"lab", "cell-size", "--quick", "--out", scratch / "out"};
  const auto lines = [&] {
    const std::string text =
        fs::exists(scratch / "out/cache/cell-size.csv") ? read_text(scratch / "out/cache/cell-size.csv") : "";
    return std::count(text.begin(), text.end(), '\n');
  };
  Program program(command);
  while (lines() < 3) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.signal(SIGINT);
  const Outcome outcome = program.wait();
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("cell-size: interrupted after ") && Contains("the same command goes on from there"));
  const auto kept = lines();
  CHECK(kept >= 3);
  CHECK(kept < find_experiment("cell-size").measurements(true));
  const std::string before = read_text(scratch / "out/cache/cell-size.csv");
  REQUIRE(run_program(command).status == 0);
  CHECK_THAT(read_text(scratch / "out/cache/cell-size.csv"), Catch::StartsWith(before));
  CHECK(lines() == find_experiment("cell-size").measurements(true));
}
