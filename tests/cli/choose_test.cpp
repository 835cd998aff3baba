// SPDX-License-Identifier: MIT
// `ballpit choose` and `--response auto` as people run them.
#include "choose/choose.h"

#include <filesystem>
#include <sstream>

#include <catch2/catch.hpp>

#include "scene/read_scene.h"
#include "show/options.h"
#include "tests/support/run_program.h"

using namespace ballpit;

namespace {

const std::string kGas =
    "[domain]\nboundary = \"periodic\"\n[physics]\nrestitution = 1\n[[fill]]\ncount = 100\nradius = 0.05\nspeed = 1\n"
    "[needs]\nduration = 1\nmax_overlap = 0.1\n";

/// The words of a command line, without "ballpit".
std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words;
  std::istringstream in(command);
  for (std::string word; in >> word;) words.push_back(word);
  words.erase(words.begin());
  return words;
}

}  // namespace

TEST_CASE("choose prints numbers, what is ruled out, pilots, one sentence and the command that runs it") {
  const Outcome outcome = run_program({"choose", "two-spheres"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Contains("the scene in numbers") && Catch::Contains("v·dt/D") &&
                              Catch::Contains("ruled out") && Catch::Contains("pilots of 2 spheres") &&
                              Catch::Contains("is the cheapest that holds all tolerances") &&
                              Catch::Contains("ballpit simulate two-spheres --response"));
  CHECK(outcome.err.empty());
}

TEST_CASE("the command that choose prints runs, with the options of its JSON") {
  const Outcome outcome = run_program({"choose", "stack", "--json"});
  REQUIRE(outcome.status == 0);
  const nlohmann::json json = outcome.json();
  for (const char* const key : {"numbers", "ruled_out", "tried", "chosen", "command", "reason"})
    CHECK(json.contains(key));
  std::vector<std::string> words = words_of(json["command"]);
  words.insert(words.end(), {"--json", "--time", "0.1"});
  const Outcome run = run_program(words);
  REQUIRE(run.status == 0);
  CHECK(run.json()["methods"]["response"] == json["chosen"]["response"]);
  CHECK(run.json()["dt"] == json["chosen"]["dt"]);
}

TEST_CASE("where nothing holds, choose says what comes nearest, and its exit status is 1") {
  Scratch scratch;
  write_text(scratch / "a.toml", kGas + "energy_tolerance = 1e-13\neffects = [\"contact-time\"]\n");
  const Outcome outcome = run_program({"choose", scratch / "a.toml", "--json"});
  CHECK(outcome.status == 1);
  CHECK(outcome.json()["chosen"].is_null());
  CHECK(outcome.json()["command"].is_null());
  CHECK_THAT(outcome.err, Catch::Contains("nothing holds all that is needed; nearest is penalty"));
}

TEST_CASE("simulate with --response auto writes its choice down, also into the trajectory") {
  Scratch scratch;
  write_text(scratch / "a.toml", kGas);
  const Outcome outcome = run_program({"simulate", scratch / "a.toml", "--response", "auto", "--json", "--trajectory",
                                       scratch / "a.xyz", "--every", "50"});
  REQUIRE(outcome.status == 0);
  const nlohmann::json json = outcome.json();
  CHECK(json["choice"]["chosen"]["response"] == json["methods"]["response"]);
  CHECK(json["choice"]["steps_up"].is_array());
  const std::string trajectory = read_text(scratch / "a.xyz");
  const size_t first = trajectory.find("choice=\"--");
  REQUIRE(first != std::string::npos);
  CHECK(trajectory.find("choice=\"", first + 1) == std::string::npos);  // once
}

TEST_CASE("render with --response auto keeps its choice in the folder, and --resume takes it from there") {
  Scratch scratch;
  write_text(scratch / "a.toml", kGas);
  const auto render = [&](const std::string& folder, const std::string& frames, bool resumes) {
    std::vector<std::string> words{"render",         scratch / "a.toml", "--response", "auto",   "--out",
                                   scratch / folder, "--frames",         frames,       "--size", "160x90"};
    if (resumes) words.push_back("--resume");
    return run_program(words).status;
  };
  REQUIRE(render("parts", "3", false) == 0);
  const std::string choice = read_text(scratch / "parts/choice.json");
  CHECK_THAT(choice, Catch::Contains("\"chosen\""));
  REQUIRE(render("parts", "6", true) == 0);
  CHECK(read_text(scratch / "parts/choice.json") == choice);
  // One choice, the same pictures.
  std::filesystem::create_directory(scratch / "whole");
  write_text(scratch / "whole/choice.json", choice);
  REQUIRE(render("whole", "6", true) == 0);
  CHECK(read_text(scratch / "whole/frame_00005.png") == read_text(scratch / "parts/frame_00005.png"));
  // A record that is none is wrong input.
  write_text(scratch / "whole/choice.json", "nonsense");
  CHECK(render("whole", "8", true) == 2);
}

TEST_CASE("an impossible step is warned of, with the one that works, and still runs") {
  const Outcome outcome =
      run_program({"simulate", "two-spheres", "--response", "penalty", "--dt", "0.1", "--time", "0.1"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Catch::Contains("warning: two-spheres: springs gain energy: a step of 0.100 s is") &&
                              Catch::Contains("times the largest stable one"));
  CHECK(run_program({"simulate", "two-spheres", "--time", "0.1"}).err.empty());
}

TEST_CASE(
    "choose answers within six seconds for every built-in scene, whose defaults cost at most twice as much, or say why",
    "[slow]") {
  for (const SceneInfo& info : built_in_scenes()) {
    const Outcome outcome = run_program({"choose", info.name, "--json"});
    INFO(info.name << ": " << outcome.err);
    REQUIRE(outcome.status == 0);
    const nlohmann::json answer = outcome.json();
    if (!is_sanitized()) CHECK(answer["seconds"].get<double>() < 6);
    const Scene scene = load_scene(info.name), part = part_of(scene, 1000);
    const auto cost = [&](const std::vector<GivenOption>& given) {
      const PilotResult run =
          run_pilot({part, scene.needs, {}, scene.needs.duration, 60}, combine(scene.defaults, given));
      return std::max(run.cost, kEqualCosts);
    };
    std::vector<GivenOption> chosen;
    for (const auto& [name, value] : answer["chosen"].items()) {
      chosen.push_back({name, value.is_string() ? value.get<std::string>() : value.dump()});
    }
    REQUIRE_FALSE(chosen.empty());
    const double of_scene = cost({}), of_choice = cost(chosen);
    INFO("the scene's defaults cost " << of_scene << " s, the choice " << of_choice << " s");
    // Under a sanitizer even tiny scenes cost more than kEqualCosts, below which all count as equal.
    if (!is_sanitized() && of_scene > 2 * of_choice) CHECK_FALSE(scene.because.empty());
  }
}
