// SPDX-License-Identifier: MIT
// ballpit pairs: the pairs of a file, the same from every broad phase, with what it took to find them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <catch2/catch.hpp>

#include "cli/pair_files.h"
#include "core/random.h"
#include "measure/exact_pairs.h"
#include "methods/methods.h"
#include "methods/settings.h"
#include "scene/input_error.h"
#include "scene/spheres_csv.h"
#include "tests/cli/run_pairs.h"
#include "tests/support/run_program.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// Spheres of radii that differ up to fourfold in a unit cube, some clustered, some at the same place.
std::string cloud(int count, double radius) {
  Random random(7);
  std::string text = "x,y,z,radius\n";
  for (int k = 0; k < count; ++k) {
    const double width = k % 4 == 0 ? 0.1 : 1.0;
    const Vec3d p = random.uniform(Vec3d(0.0), Vec3d(width));
    std::array<char, 128> row;
    std::snprintf(row.data(), row.size(), "%.17g,%.17g,%.17g,%.17g\n", p.x, p.y, p.z,
                  radius * random.uniform(0.25, 1.0));
    for (int times = k % 50 == 0 ? 2 : 1; times > 0; --times) text += row.data();
  }
  return text;
}

std::string exact_csv(const std::string& text) {
  const RestingSpheres spheres = read_resting_spheres({text, "cloud"});
  return pairs_csv(exact_pairs({{spheres.position.data(), spheres.size()}, {spheres.radius.data(), spheres.size()}}));
}

}  // namespace

TEST_CASE("the pairs of a file are written sorted, each once, touching ones too") {
  const Scratch scratch;
  write_text(scratch / "four.csv", kFour);
  for (const std::string& method : search_methods()) {
    INFO(method);
    const nlohmann::json summary =
        pairs({scratch / "four.csv", "--out", scratch / "pairs.csv", "--broadphase", method});
    CHECK(read_text(scratch / "pairs.csv") == kPairsOfFour);
    CHECK(summary["count"] == 4);
    CHECK(summary["contacts"] == 3);
  }
  CHECK_FALSE(fs::exists(scratch / "pairs.csv.part"));
}

TEST_CASE("every broad phase finds the pairs of the exact reference, with any number of threads") {
  const Scratch scratch;
  const std::string text = cloud(3000, 0.05);
  write_text(scratch / "cloud.csv", text);
  const std::string expected = exact_csv(text);
  CHECK(std::count(expected.begin(), expected.end(), '\n') > 1000);
  for (const std::string& method : search_methods()) {
    for (const char* threads : {"1", "3"}) {
      INFO(method << " on " << threads << " threads");
      pairs({scratch / "cloud.csv", "--out", scratch / "pairs.csv", "--broadphase", method, "--threads", threads});
      CHECK((read_text(scratch / "pairs.csv") == expected));  // in brackets: not printed
    }
  }
}

TEST_CASE("pairs --json prints one object with all that was promised") {
  const Scratch scratch;
  write_text(scratch / "cloud.csv", cloud(500, 0.1));
  const nlohmann::json summary =
      pairs({scratch / "cloud.csv", "--broadphase", "brute-force", "--backend", "cpu", "--threads", "2"});
  const int64_t n = summary["count"];
  CHECK(n == 510);
  CHECK(summary["file"] == scratch / "cloud.csv");
  CHECK(summary["method"] == "brute-force");
  CHECK_FALSE(summary.contains("reason"));
  CHECK(summary["backend"] == "cpu");
  CHECK(summary["threads"] == 2);
  CHECK(summary["contacts"].get<int64_t>() > 0);
  CHECK(summary["candidates"] == n * (n - 1) / 2);
  CHECK(summary["seconds"].get<double>() > 0);
  CHECK_FALSE(summary.contains("seconds_min"));
  CHECK(summary["bytes"].get<int64_t>() > 0);
  CHECK_FALSE(summary["stages"].empty());
  CHECK_FALSE(summary.contains("missed"));
  CHECK_FALSE(summary.contains("duplicate"));
}

TEST_CASE("the histogram of work counts every thread once, and a warp is never busier than it can be") {
  const Scratch scratch;
  write_text(scratch / "cloud.csv", cloud(1000, 0.05));
  for (const std::string& method : search_methods()) {
    INFO(method);
    const nlohmann::json work = pairs({scratch / "cloud.csv", "--broadphase", method})["work"];
    int64_t threads = 0, next = 0;
    for (const nlohmann::json& bin : work["histogram"]) {
      CHECK(bin["from"] == next);
      next = bin["to"].get<int64_t>() + 1;
      threads += bin["threads"].get<int64_t>();
    }
    CHECK(threads == work["threads"]);
    CHECK(threads > 0);
    CHECK(work["max"].get<int64_t>() < next);
    CHECK(work["mean"].get<double>() <= work["max"].get<double>());
    CHECK(work["warp_size"] == 32);
    CHECK(work["simd_efficiency"].get<double>() > 0);
    CHECK(work["simd_efficiency"].get<double>() <= 1);
  }
}

TEST_CASE("every broad phase and the exact reference find the pairs across the ends of a period") {
  const Scratch scratch;
  write_text(scratch / "cloud.csv", cloud(1000, 0.05));  // in a unit cube
  std::string expected;
  int64_t contacts = 0;
  for (const char* period : {"1,1,1", "1,1,0", "0,1,0", "0,0,1.5", "0,0,0"}) {
    expected.clear();
    for (const std::string& method : search_methods()) {
      INFO(method << " with " << period);
      const nlohmann::json summary = pairs({scratch / "cloud.csv", "--verify", "--period", period, "--broadphase",
                                            method, "--out", scratch / "pairs.csv"});
      CHECK(summary["missed"] == 0);
      CHECK(summary["wrong"] == 0);
      CHECK(summary["duplicate"] == 0);
      if (expected.empty()) {
        expected = read_text(scratch / "pairs.csv");
        CHECK((contacts == 0 || summary["contacts"].get<int64_t>() < contacts));  // fewer than with all periods
        if (contacts == 0) contacts = summary["contacts"];
      }
      CHECK((read_text(scratch / "pairs.csv") == expected));
    }
  }
  pairs({scratch / "cloud.csv", "--out", scratch / "none.csv"});
  CHECK((read_text(scratch / "none.csv") == expected));  // of no period at all
}

TEST_CASE("touching spheres of a periodic crystal have as many contacts in pairs as in simulate") {
  const Scratch scratch;
  // Face-centred cubic: twelve neighbours each, six contacts a sphere. A little too large, so that rounding parts none.
  std::string text = "x,y,z,radius\n";
  const double edge = std::sqrt(2.0);
  for (int cell = 0; cell < 27; ++cell) {
    const Vec3d corner = edge * Vec3d(cell % 3, cell / 3 % 3, cell / 9);
    for (const Vec3d& site : {Vec3d(0, 0, 0), Vec3d(0.5, 0.5, 0), Vec3d(0.5, 0, 0.5), Vec3d(0, 0.5, 0.5)}) {
      const Vec3d p = corner + edge * site;
      text += number_text(p.x) + ',' + number_text(p.y) + ',' + number_text(p.z) + ",0.50025\n";
    }
  }
  write_text(scratch / "fcc.csv", text);
  const std::string period = number_text(3 * edge);
  write_text(scratch / "fcc.toml", "spheres = 'fcc.csv'\n[domain]\nboundary = 'periodic'\nmin = [0, 0, 0]\nmax = [" +
                                       period + ", " + period + ", " + period +
                                       "]\n[physics]\ninitial_overlap = 0.01\n");
  const Outcome simulated =
      run_program({"simulate", scratch / "fcc.toml", "--time", "0", "--json", "--out", scratch / "state.csv"});
  INFO(simulated.err);
  CHECK(simulated.json()["contacts"] == 648);
  CHECK(pairs({scratch / "fcc.toml", "--verify"})["contacts"] == 648);
  const nlohmann::json summary =
      pairs({scratch / "state.csv", "--verify", "--period", period + "," + period + "," + period});
  CHECK(summary["contacts"] == 648);
  CHECK(summary["missed"] == 0);
  CHECK(summary["period"][2] == 3 * edge);
  CHECK(pairs({scratch / "state.csv"})["contacts"] == 450);
}

TEST_CASE("pairs reads built-in scenes, planar ones too, and finds the contacts of simulate") {
  for (const char* scene : {"gas-dense", "lecture-grid", "cradle", "bouncing-balls"}) {
    INFO(scene);
    const Outcome simulated = run_program({"simulate", scene, "--time", "0", "--json"});
    const nlohmann::json found = pairs({scene, "--verify"});
    CHECK(found["count"] == simulated.json()["count"]);
    CHECK(found["contacts"] == simulated.json()["contacts"]);
    CHECK(found["missed"] == 0);
    CHECK(found["wrong"] == 0);
  }
}

TEST_CASE("centres outside of the period are searched at their images, and told in one line") {
  const Scratch scratch;
  write_text(scratch / "a.csv", "x,y,z,radius\n0.1,0,0,0.2\n99.9,0,0,0.2\n-50.2,7,0,0.05\n");
  const Outcome outcome = run_program({"pairs", scratch / "a.csv", "--period", "10,0,0", "--json", "--verify"});
  CHECK(outcome.status == 0);
  CHECK(outcome.json()["contacts"] == 1);
  CHECK(outcome.json()["missed"] == 0);
  CHECK_THAT(outcome.err, Contains("a.csv: 2 of 3 spheres were outside of the period"));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

TEST_CASE("a period that cannot be is refused with what is allowed") {
  const Scratch scratch;
  write_text(scratch / "four.csv", kFour);
  const auto error_of = [&](const std::string& file, const std::string& period) {
    const Outcome outcome = run_program({"pairs", file, "--period", period});
    CHECK(outcome.status == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    return outcome.err;
  };
  const std::string file = scratch / "four.csv";
  for (const char* period : {"", "1", "1,2", "1,2,3,4"}) CHECK_THAT(error_of(file, period), Contains("allowed X,Y,Z"));
  for (const char* period : {"1,2,x", "-1,0,0", "nan,0,0", "inf,0,0", "1e16,0,0"}) {
    CHECK_THAT(error_of(file, period), Contains("--period: found") && Contains("allowed a number from 0 to"));
  }
  CHECK_THAT(error_of(file, "0,7,0"),
             Contains("--period: found 7 along y with radius 2, allowed 0 for none, or at least four radii, 8"));
  CHECK_THAT(error_of("gas-dense", "9,9,9"),
             Contains("--period: found with the scene gas-dense, which has its own period"));
}

TEST_CASE("columns that are not read are named in one warning") {
  const Scratch scratch;
  write_text(scratch / "a.csv", ",x,y,z,radius,tag\n0,0,0,0,0.5,a\n1,0.9,0,0,0.5,b\n");
  write_text(scratch / "a.toml",
             "spheres = 'a.csv'\n[domain]\nmin = [-1, -1, -1]\nmax = [2, 2, 2]\n[physics]\ninitial_overlap = 1\n");
  const std::string warning = "ballpit: warning: " + scratch / "a.csv" +
                              ":1: what these columns hold is ignored: column 1 without a name, \"tag\"\n";
  const Outcome searched = run_program({"pairs", scratch / "a.csv", "--json"});
  CHECK(searched.err == warning);
  CHECK(searched.json()["contacts"] == 1);
  CHECK(run_program({"simulate", scratch / "a.toml", "--time", "0.01"}).err == warning);
}

TEST_CASE("automatic choice says what it chose, and why") {
  const std::vector<std::string> names = search_methods();
  if (std::find(names.begin(), names.end(), "auto") == names.end()) return;
  const Scratch scratch;
  write_text(scratch / "four.csv", kFour);
  const nlohmann::json summary = pairs({scratch / "four.csv", "--broadphase", "auto"});
  CHECK(summary["method"] != "auto");
  CHECK_FALSE(summary["reason"].get<std::string>().empty());
  const Outcome outcome = run_program({"pairs", scratch / "four.csv", "--broadphase", "auto"});
  CHECK_THAT(outcome.out, Contains(summary["reason"].get<std::string>()));
}

TEST_CASE("repeated searches tell median, least and quartiles") {
  const Scratch scratch;
  write_text(scratch / "four.csv", kFour);
  const nlohmann::json summary = pairs({scratch / "four.csv", "--repeat", "7"});
  CHECK(summary["repeat"] == 7);
  CHECK(summary["contacts"] == 3);
  CHECK(summary["seconds_min"] <= summary["seconds_quartiles"][0]);
  CHECK(summary["seconds_quartiles"][0] <= summary["seconds"]);
  CHECK(summary["seconds"] <= summary["seconds_quartiles"][1]);
}

TEST_CASE("verification finds nothing wrong with any broad phase") {
  const Scratch scratch;
  write_text(scratch / "cloud.csv", cloud(2000, 0.05));
  for (const std::string& method : search_methods()) {
    INFO(method);
    const nlohmann::json summary = pairs({scratch / "cloud.csv", "--verify", "--broadphase", method});
    CHECK(summary["missed"] == 0);
    CHECK(summary["wrong"] == 0);
    CHECK(summary["duplicate"] == 0);
  }
}

TEST_CASE("verification finds the pairs that cells smaller than a diameter miss, after a warning") {
  const Scratch scratch;
  write_text(scratch / "cloud.csv", cloud(2000, 0.05));
  const Outcome outcome = run_program(
      {"pairs", scratch / "cloud.csv", "--verify", "--json", "--broadphase", "linked-cell", "--cell-size", "0.3"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Contains("--cell-size 0.3") && Contains("missed"));
  CHECK(outcome.json()["missed"].get<int64_t>() > 0);
  CHECK(outcome.json()["wrong"] == 0);
}

TEST_CASE("pairs says the same for people, and nothing on standard error") {
  const Scratch scratch;
  write_text(scratch / "four.csv", kFour);
  const Outcome outcome = run_program({"pairs", scratch / "four.csv", "--broadphase", "linked-cell", "--verify"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, Contains("4 in ") && Contains("four.csv") && Contains("linked-cell") &&
                              Contains("3 among ") && Contains("0 missed"));
}

TEST_CASE("the help of pairs names the settings of a search, and no others") {
  const Outcome outcome = run_program({"pairs", "--help"});
  CHECK(outcome.status == 0);
  for (const SettingInfo& setting : setting_table()) {
    const std::string option = "--" + std::string(setting.name) + " ";
    const bool applies =
        Catch::Matches("broadphase|cell-size|axis|table|backend|threads").match(std::string(setting.name));
    INFO(option);
    CHECK((outcome.out.find(option) != std::string::npos) == applies);
    if (applies) CHECK_THAT(outcome.out, Contains(std::string(setting.help) + ": " + setting.allowed));
  }
}
