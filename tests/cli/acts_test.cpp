// SPDX-License-Identifier: MIT
// --acts: the same run however it is computed, in all commands that take it, and what is refused.
#include <catch2/catch.hpp>

#include "tests/cli/run_simulate.h"
#include "tests/support/run_program.h"

using namespace ballpit;

namespace {

const std::string kThrow = "[[act]]\ntime = 0.1\nact = \"throw\"\nsphere = 3\nvector = [1, 3]\n";
const std::string kDrop = "[[act]]\ntime = 0.2\nact = \"drop\"\nvector = [1.6, 4.4]\nradius = 0.2\n";
const std::string kPush = "[[act]]\ntime = 0.2\nact = \"push\"\nsphere = 20\nvector = [0, -1]\nreach = 1.5\n";

std::string file_of(const Scratch& scratch, const std::string& text) {
  write_text(scratch / "acts.toml", text);
  return scratch / "acts.toml";
}

}  // namespace

TEST_CASE("acts give the same state with every response on any threads and broad phase") {
  const Scratch scratch;
  const std::string acts = file_of(scratch, kThrow + kDrop + kPush);
  for (const char* const response : {"kinematic", "impulse", "penalty", "position-based", "event-driven"}) {
    const auto summary = [&](std::vector<std::string> more) {
      for (const std::string& word : {std::string("lecture-grid"), std::string("--time"), std::string("0.5"),
                                      std::string("--response"), std::string(response)}) {
        more.push_back(word);
      }
      return run_simulate(more).json();
    };
    const nlohmann::json one = summary({"--acts", acts, "--threads", "1"});
    CHECK(one["count"] == 21);
    CHECK(one["time"].get<double>() == Approx(0.5));
    CHECK(summary({"--acts", acts, "--threads", "2"})["state_hash"] == one["state_hash"]);
    CHECK(summary({})["state_hash"] != one["state_hash"]);
    if (response == std::string("event-driven")) continue;
    CHECK(summary({"--acts", acts, "--broadphase", "brute-force"})["state_hash"] == one["state_hash"]);
  }
}

TEST_CASE("an observed run and a trajectory go on with a sphere that is dropped in") {
  const Scratch scratch;
  const Outcome outcome = run_simulate({"lecture-grid", "--time", "0.5", "--acts", file_of(scratch, kDrop), "--observe",
                                        "all", "--trajectory", scratch / "run.xyz", "--every", "40"});
  CHECK(outcome.err.empty());
  const std::string frames = read_text(scratch / "run.xyz");
  CHECK_THAT(frames, Catch::StartsWith("20\n"));
  CHECK_THAT(frames, Catch::Contains("\n21\n"));
}

TEST_CASE("a film with other acts is another film") {
  const Scratch scratch;
  const auto film = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render", "lecture-grid", "--out", scratch / "film", "--frames",
                                       "2",      "--size",       "64x36"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  };
  const std::string acts = file_of(scratch, kThrow);
  CHECK(film({"--acts", acts}).status == 0);
  CHECK(film({"--acts", acts, "--resume"}).status == 0);
  const Outcome other = film({"--resume"});
  CHECK(other.status == 2);
  CHECK_THAT(other.err, Catch::Contains("allowed frames with acts none"));
}

TEST_CASE("a run without room for a sphere ends with one line, nothing half-written is left") {
  const Scratch scratch;
  const std::string drop = "[[act]]\ntime = 0.2\nact = \"drop\"\nvector = [1.5, 1.5]\n";
  const Outcome outcome = run_program(
      {"simulate", "lecture-grid", "--time", "0.5", "--out", scratch / "state.csv", "--acts", file_of(scratch, drop)});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Catch::StartsWith("ballpit: drop at t = 0.2 s: no room for a sphere of radius 0.25 m at "
                                            "(1.5, 1.5, 0): sphere 0 is 0.4"));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(outcome.out.empty());
}
