// SPDX-License-Identifier: MIT
// ballpit bench: an entry for everything asked for, measured or skipped with the reason, and the gas it measures.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <numbers>
#include <thread>

#include <catch2/catch.hpp>

#include "measure/exact_pairs.h"
#include "measure/step_timing.h"
#include "methods/methods.h"
#include "tests/support/run_program.h"

using namespace ballpit;
using Catch::Contains;

namespace {

Outcome bench(Arguments arguments) {
  arguments.insert(arguments.begin(), "bench");
  Outcome outcome = run_program(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.err.empty());
  return outcome;
}

std::vector<std::string> measured_methods() {
  std::vector<std::string> names;
  for (const std::string_view name : kNames<BroadPhase>) {
    if (name != "auto" && !is_of_lecture(named<BroadPhase>(name))) names.emplace_back(name);
  }
  return names;
}

void check_measured(const nlohmann::json& entry) {
  CHECK(entry["seconds"].get<double>() > 0);
  CHECK(entry["seconds_min"] <= entry["seconds_quartiles"][0]);
  CHECK(entry["seconds_quartiles"][0] <= entry["seconds"]);
  CHECK(entry["seconds"] <= entry["seconds_quartiles"][1]);
  CHECK(entry["speedup"].get<double>() > 0);
  CHECK(entry["steps"].get<int>() >= 1);
  CHECK_FALSE(entry["stages"].empty());
  for (const nlohmann::json& stage : entry["stages"]) {
    CHECK(stage["seconds"].get<double>() >= 0);
    CHECK(stage["launches"].get<double>() > 0);
  }
}

}  // namespace

TEST_CASE("bench --json is one object with the machine, and an entry for every count, thread number and method") {
  const nlohmann::json summary =
      bench({"--json", "--counts", "300,100", "--threads", "2,1", "--backends", "cpu", "--repeat", "2"}).json();
  CHECK_FALSE(summary["machine"]["cpu"].get<std::string>().empty());
  CHECK(summary["machine"]["cores"].get<int>() >= 1);
  CHECK(summary["machine"].contains("compiler"));
  CHECK(summary["machine"].contains("build_type"));
  CHECK(summary["repeat"] == 2);
  CHECK(summary["baseline"] == measured_methods().front());
  size_t k = 0;
  for (const int count : {100, 300}) {
    for (const int threads : {1, 2}) {
      for (const std::string& method : measured_methods()) {
        INFO(count << " spheres, " << threads << " threads, " << method);
        REQUIRE(k < summary["entries"].size());
        const nlohmann::json& entry = summary["entries"][k++];
        CHECK(entry["count"] == count);
        CHECK(entry["threads"] == threads);
        CHECK(entry["method"] == method);
        CHECK(entry["backend"] == "cpu");
        check_measured(entry);
        if (method == "brute-force") CHECK(entry["candidates"] == count * (count - 1) / 2);
        if (method == summary["baseline"]) CHECK(entry["speedup"] == 1.0);
      }
    }
  }
  CHECK(k == summary["entries"].size());
}

TEST_CASE("the stages of an entry are those of a step, launched once in it and not for the report") {
  const nlohmann::json summary =
      bench({"--json", "--counts", "500", "--methods", "brute-force", "--threads", "1", "--backends", "cpu"}).json();
  std::vector<std::string> names;
  for (const nlohmann::json& stage : summary["entries"][0]["stages"]) {
    names.push_back(stage["name"]);
    if (names.back() == "correct positions and drift") CHECK(stage["launches"] == 1.0);
    if (names.back().rfind("check ", 0) == 0 || names.back() == "keep state" || names.back() == "lower flag") {
      continue;  // the guard's: now and then
    }
    CHECK(stage["launches"].get<double>() == Approx(std::round(stage["launches"].get<double>())));
  }
  CHECK(std::find(names.begin(), names.end(), "correct positions and drift") != names.end());
}

TEST_CASE("what would take longer than the limit is skipped, and says so, the rest is measured") {
  const Arguments arguments{"--counts", "50,500000", "--methods", "brute-force", "--threads",  "1",
                            "--repeat", "3",         "--limit",   "0.5",         "--backends", "cpu"};
  Arguments json = arguments;
  json.emplace_back("--json");
  const nlohmann::json entries = bench(json).json()["entries"];
  REQUIRE(entries.size() == 2);
  CHECK_FALSE(entries[0].contains("skipped"));
  check_measured(entries[0]);
  CHECK_FALSE(entries[1].contains("seconds"));
  CHECK_THAT(entries[1]["skipped"].get<std::string>(), Contains("--limit is 0.5 s"));
  CHECK_THAT(bench(arguments).out, Contains("skipped: a step "));
}

TEST_CASE("bench prints a line an entry for people, and each stage where that is asked for") {
  const Arguments arguments{"--counts", "100", "--threads", "1", "--backends", "cpu", "--repeat", "2"};
  const std::string table = bench(arguments).out;
  for (const std::string& method : measured_methods()) CHECK_THAT(table, Contains("100  " + method));
  CHECK_THAT(table, Contains("ms a step") && Contains("quartiles") && Contains("cores"));
  CHECK_FALSE(Contains("resolve velocities").match(table));
  Arguments with_stages = arguments;
  with_stages.emplace_back("--stages");
  CHECK_THAT(bench(with_stages).out, Contains("resolve velocities"));
}

TEST_CASE("an interrupted bench says how far it came") {
  Program program({"bench", "--counts", "100", "--repeat", "1000", "--limit", "1000"});
  REQUIRE(program.wait_until_it_catches(SIGINT));
  program.signal(SIGINT);
  const Outcome outcome = program.wait();
  CHECK(outcome.status == 1);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Contains("interrupted after 0 of "));
}

TEST_CASE("the gas fills its share of its cube without overlap, and is the same every time, for each seed another") {
  for (const int64_t count : {1, 27, 1000}) {
    const Scene gas = make_gas(count);
    INFO(count << " spheres");
    REQUIRE(gas.bodies.size() == count);
    CHECK(gas.bodies.position == make_gas(count).bodies.position);
    CHECK(gas.bodies.velocity == make_gas(count).bodies.velocity);
    CHECK(gas.bodies.velocity != make_gas(count, 2).bodies.velocity);
    std::vector<Vec3> position;
    double volume = 0;
    for (int64_t i = 0; i < count; ++i) {
      const double radius = gas.bodies.radius[i];
      volume += 4.0 / 3 * std::numbers::pi * radius * radius * radius;
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(gas.bodies.position[i][axis] >= radius);
        CHECK(gas.bodies.position[i][axis] <= gas.domain.max[axis] - radius);
      }
      position.push_back(narrow<Vec3>(gas.bodies.position[i]));
    }
    const double edge = gas.domain.max.x;
    CHECK(volume / (edge * edge * edge) == Approx(kGasVolumeFraction));  // cubes of numbers fill their lattice
    const auto radius = static_cast<float>(gas.bodies.radius[0]);
    CHECK(exact_pairs({{position.data(), count}, {&radius, 1}}).empty());
  }
}
