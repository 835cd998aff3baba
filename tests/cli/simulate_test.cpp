// SPDX-License-Identifier: MIT
// ballpit simulate: the summary, the same bits for any threads and broad phase, and states that start again.
#include <cmath>

#include <catch2/catch.hpp>

#include "methods/methods.h"
#include "tests/cli/run_simulate.h"
#include "tests/support/run_program.h"

using namespace ballpit;

namespace {

nlohmann::json simulate(const Arguments& arguments) {
  const Outcome outcome = run_simulate(arguments);
  CHECK(outcome.err.empty());
  return outcome.json();  // throws if there is anything but the object
}

}  // namespace

TEST_CASE("simulate --json prints one object with all that was promised") {
  const nlohmann::json summary = simulate({"bouncing-balls", "--time", "0.1"});
  CHECK(summary["scene"] == "bouncing-balls");
  CHECK(summary["count"] == 2000);
  CHECK(summary["dt"].get<double>() > 0);
  CHECK(summary["steps"] == std::llround(0.1 / summary["dt"].get<double>()));
  CHECK(summary["time"].get<double>() == Approx(0.1));
  CHECK(summary["seconds"].get<double>() > 0);
  CHECK(summary["methods"]["broadphase"] == "linked-cell");
  CHECK(summary["methods"]["response"] == "impulse");
  CHECK(summary["methods"]["backend"] != "auto");
  CHECK(summary["candidates"].get<int64_t>() > summary["contacts"].get<int64_t>());
  CHECK(summary["searches"] == summary["steps"].get<int64_t>() + 1);  // and once at the start
  CHECK(summary["bytes"].get<int64_t>() > 0);
  CHECK_FALSE(summary.contains("reason"));
  CHECK(summary["kinetic_energy"].get<double>() > 0);
  CHECK(summary["potential_energy"].get<double>() > 0);
  CHECK(summary["momentum"].size() == 3);
  CHECK(summary["max_overlap"].get<double>() >= 0);
  CHECK_THAT(summary["state_hash"].get<std::string>(), Catch::Matches("[0-9a-f]{16}"));
  CHECK_FALSE(summary["stages"].empty());
}

TEST_CASE("the summary has the choice of auto, its reason, and the number of searches with a skin") {
  const nlohmann::json summary = simulate({"bouncing-balls", "--time", "0.1", "--broadphase", "auto", "--skin", "5"});
  CHECK(summary["methods"]["broadphase"] != "auto");
  CHECK_THAT(summary["reason"].get<std::string>(), Catch::Contains("predicted"));
  CHECK(summary["searches"] < summary["steps"].get<int64_t>() / 2);
}

TEST_CASE("a file whose name is no UTF-8 is simulated, and named as far as JSON can") {
  const Scratch scratch;
  write_text(scratch / "dr\xF6p.toml", "[domain]\n[[fill]]\ncount = 3\nradius = 0.02\n");
  CHECK_THAT(simulate({scratch / "dr\xF6p.toml", "--time", "0.01"})["scene"].get<std::string>(),
             Catch::StartsWith("dr"));
}

TEST_CASE("simulate says the same for people, and nothing on standard error") {
  const Outcome outcome = run_program({"simulate", "two-spheres"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, Catch::Contains("two-spheres, 2 spheres") && Catch::Contains("state hash"));
}

TEST_CASE("the default scene is the bouncing balls, and the default time the scene's duration") {
  CHECK(simulate({"--time", "0"})["scene"] == "bouncing-balls");
  CHECK(simulate({"two-spheres"})["time"].get<double>() == Approx(3));
}

TEST_CASE("500 steps give the same bits for 1, 2 and 8 threads and for every broad phase") {
  const double dt = simulate({"--time", "0"})["dt"];
  const auto hash_of = [&](const Arguments& options) {
    const nlohmann::json summary =
        simulate(with({"bouncing-balls", "--backend", "cpu", "--time", std::to_string(500 * dt)}, options));
    CHECK(summary["steps"] == 500);
    return summary["state_hash"].get<std::string>();
  };
  const std::string expected = hash_of({"--threads", "1"});
  CHECK(hash_of({"--threads", "1"}) == expected);
  CHECK(hash_of({"--threads", "2"}) == expected);
  CHECK(hash_of({"--threads", "8"}) == expected);
  for (const std::string_view method : kNames<BroadPhase>) {
    INFO(method);
    CHECK(hash_of({"--threads", "2", "--broadphase", std::string(method)}) == expected);
  }
  CHECK(hash_of({"--seed", "2"}) != expected);
}

TEST_CASE("the seed decides where spheres start") {
  const auto hash_of = [](const char* seed) { return simulate({"--time", "0", "--seed", seed})["state_hash"]; };
  CHECK(hash_of("5") == hash_of("5"));
  CHECK(hash_of("5") != hash_of("6"));
}

TEST_CASE("the option --count replaces the scene's number of spheres") {
  CHECK(simulate({"--time", "0", "--count", "123"})["count"] == 123);
}

TEST_CASE("a written state starts again with the same bits, and goes on as the run does") {
  const Scratch scratch;
  const std::string physics = "[physics]\ngravity = [0, -9.81, 0]\ninitial_overlap = 1\n";
  const std::string domain = GENERATE(as<std::string>{}, "[domain]\n", "[domain]\nboundary = 'periodic'\n",
                                      "[domain]\nboundary = 'open-top'\n", "[domain]\ndimensions = 2\n");
  write_text(scratch / "first.toml", domain + physics + "[[fill]]\ncount = 60\nradius = [0.02, 0.04]\nspeed = 1\n");
  write_text(scratch / "second.toml", "spheres = 'state.csv'\n" + domain + physics);
  const nlohmann::json written =
      simulate({scratch / "first.toml", "--dt", "0.001", "--time", "0.4", "--out", scratch / "state.csv"});
  const nlohmann::json again = simulate({scratch / "second.toml", "--dt", "0.001", "--time", "0"});
  CHECK(again["state_hash"] == written["state_hash"]);
  CHECK(again["count"] == 60);
  CHECK(again["contacts"] == written["contacts"]);
  CHECK(again["kinetic_energy"].get<double>() == Approx(written["kinetic_energy"].get<double>()));
  CHECK(simulate({scratch / "second.toml", "--dt", "0.001", "--time", "0.1"})["state_hash"] ==
        simulate({scratch / "first.toml", "--dt", "0.001", "--time", "0.5"})["state_hash"]);
}

TEST_CASE("a cell size below one is run, with a warning that contacts are missed") {
  const Outcome outcome = run_program({"simulate", "two-spheres", "--time", "0", "--cell-size", "0.5", "--json"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Catch::Contains("--cell-size 0.5") && Catch::Contains("missed"));
  CHECK(outcome.json()["count"] == 2);
}
