// SPDX-License-Identifier: MIT
// Wrong command lines: status 2 and one line that names the option, what was found and what is allowed.
#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "methods/settings.h"
#include "scene/read_scene.h"
#include "tests/support/run_program.h"
#include "world/observables.h"
#include "world/world.h"

using namespace ballpit;
using Catch::Contains;

namespace {

/// Runs the program on input that is wrong, and returns its one line.
std::string error_of(const Arguments& arguments) {
  const Outcome outcome = run_program(arguments);
  INFO(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK_THAT(outcome.err, Catch::StartsWith("ballpit: ") && Catch::EndsWith("\n"));
  return outcome.err;
}

struct Wrong {
  Arguments arguments;
  std::string message;  ///< what the line says after "ballpit: ", or begins with
};

void check_all(const std::vector<Wrong>& table) {
  for (const Wrong& wrong : table) {
    std::string line;
    for (const std::string& word : wrong.arguments) line += " '" + word + "'";
    INFO("ballpit" << line);
    CHECK_THAT(error_of(wrong.arguments), Catch::StartsWith("ballpit: " + wrong.message));
  }
}

/// A command with options that make it a valid one, quick, and without a picture that anybody sees.
Arguments valid(const std::string& command) {
  if (command == "render") return {"render", "two-spheres", "--out", "/proc/nowhere", "--frames", "1"};
  if (command == "pairs") return {"pairs", "/proc/nowhere.csv"};
  if (command == "bench") return {"bench"};
  return {"simulate", "two-spheres", "--time", "0"};
}

}  // namespace

TEST_CASE("a command that does not exist is refused with those that do") {
  const std::string allowed =
      ", allowed show, lecture, render, simulate, choose, pairs, compare, bench, lab, list, doctor, --help, "
      "--version\n";
  check_all({
      {{}, "command: found nothing" + allowed},
      {{""}, "command: found nothing" + allowed},
      {{"simulat"}, "command: found simulat" + allowed},
      {{"--frob"}, "command: found --frob" + allowed},
      {{"--json", "simulate"}, "command: found --json" + allowed},
      {{"--"}, "command: found --" + allowed},
  });
}

TEST_CASE("an option that does not exist is refused with those that do") {
  const std::vector<Arguments> commands{
      {"render", "--out", "x"}, {"simulate"}, {"pairs", "x.csv"}, {"bench"}, {"list"}, {"doctor"}};
  for (const Arguments& arguments : commands) {
    const std::string& command = arguments.front();
    const std::string error = error_of(with(arguments, {"--frob"}));
    CHECK_THAT(error, Contains(command + ": found unknown option --frob, allowed --help"));
    CHECK_THAT(error, Contains("--json"));
    CHECK_THAT(error, Contains("see `ballpit " + command + " --help`"));
  }
  for (const SettingInfo& setting : setting_table()) {
    CHECK_THAT(error_of({"simulate", "--frob"}), Contains("--" + std::string(setting.name)));
  }
}

TEST_CASE("an option without its value, with two, or a flag with one is refused") {
  check_all({
      {{"simulate", "--time"}, "--time: found nothing, allowed SECONDS (simulated time"},
      {{"simulate", "--time="}, "--time: found nothing, allowed SECONDS"},
      {{"simulate", "--dt"}, "--dt: found nothing, allowed SECONDS (time step: 1e-12 to 10"},
      {{"simulate", "--dt", "--json"}, "--dt: found --json, allowed 1e-12 to 10"},
      {{"simulate", "--seed", "1", "--seed", "2"}, "--seed: found 2 values, allowed one"},
      {{"simulate", "--json=5"}, "--json: found a value, allowed none"},
      {{"list", "--json=5"}, "--json: found a value, allowed none"},
      {{"doctor", "--json=5"}, "--json: found a value, allowed none"},
      {{"render", "--out", "x", "--resume=no"}, "--resume: found a value, allowed none"},
      {{"render"}, "--out: found nothing, allowed --out DIR, --film FILE.mp4 or both"},
      {{"render", "--out"}, "--out: found nothing, allowed DIR"},
      {{"render", "--out", ""}, "--out: found nothing, allowed a path"},
      {{"simulate", "--out", ""}, "--out: found nothing, allowed a path"},
      {{"pairs"}, "FILE: found nothing, allowed CSV (spheres as CSV"},
      {{"pairs", ""}, "FILE: found nothing, allowed a path"},
      {{"pairs", "x.csv", "--out", ""}, "--out: found nothing, allowed a path"},
      {{"pairs", "x.csv", "--verify=1"}, "--verify: found a value, allowed none"},
      {{"bench", "--counts"}, "--counts: found nothing, allowed N,… (numbers of spheres"},
  });
}

TEST_CASE("words that no option asked for are refused") {
  check_all({
      {{"simulate", "rain", "extra"}, "simulate: found extra, allowed one SCENE and options"},
      {{"list", "extra"}, "list: found extra, allowed options alone"},
      {{"doctor", "extra"}, "doctor: found extra, allowed options alone"},
      {{"pairs", "x.csv", "extra"}, "pairs: found extra, allowed one FILE and options"},
      {{"pairs", "x.csv", "--dt", "1"}, "pairs: found unknown option --dt, allowed --help, --out, --repeat"},
      {{"bench", "extra"}, "bench: found extra, allowed options alone"},
      {{"simulate", "--json", "3"}, "SCENE: found \"3\", allowed bouncing-balls"},
  });
}

TEST_CASE("numbers that are none, not finite or out of range are refused by every option that takes one") {
  struct Option {
    const char* command;
    std::string name;
    std::string allowed;
  };
  std::vector<Option> options{
      {"simulate", "time", "a number from 0 to 1e9"},      {"simulate", "every", "an integer from 1 to 1000000000"},
      {"render", "frames", "an integer from 1 to 100000"}, {"render", "fps", "a number from 0.001 to 1e6"},
      {"render", "every", "an integer from 1 to 1000000"}, {"render", "from", "a number from 0 to 1e9"},
      {"render", "supersample", "an integer from 1 to 4"}, {"render", "size", "WIDTHxHEIGHT, each from 16 to 16384"},
      {"pairs", "repeat", "an integer from 1 to 10000"},   {"bench", "counts", "an integer from 1 to 100000000"},
      {"bench", "threads", "an integer from 0 to 256"},    {"bench", "repeat", "an integer from 1 to 1000"},
      {"bench", "limit", "a number from 0.001 to 1e6"},
  };
  for (const SettingInfo& setting : setting_table())
    options.push_back({"simulate", std::string(setting.name), setting.allowed});
  for (const Option& option : options) {
    for (const char* value : {"nan", "inf", "-inf", "-1", "", "abc", "1e999", "99999999999999999999", "0x10", "1 "}) {
      const std::string name = "--" + option.name;
      Arguments arguments = valid(option.command);
      if (option.name == "time" || option.name == "frames") arguments.resize(arguments.size() - 2);
      INFO(name << " '" << value << "'");
      const std::string error = error_of(with(arguments, {name, value}));
      CHECK_THAT(error, Catch::StartsWith("ballpit: " + name + ": found ") && Contains(value) &&
                            Contains(", allowed " + option.allowed));
    }
  }
}

TEST_CASE("shared options are refused by render as by simulate") {
  for (const SettingInfo& setting : setting_table()) {
    const std::string name = "--" + std::string(setting.name);
    CHECK_THAT(error_of(with(valid("render"), {name, "wrong"})),
               Contains(name + ": found wrong, allowed " + setting.allowed));
  }
}

TEST_CASE("settings of a search are refused by pairs as by simulate") {
  for (const SettingInfo& setting : setting_table()) {
    const std::string name = "--" + std::string(setting.name);
    const std::string error = error_of(with(valid("pairs"), {name, "wrong"}));
    const bool applies = error.find("unknown option") == std::string::npos;
    if (applies) CHECK_THAT(error, Contains(name + ": found wrong, allowed " + setting.allowed));
  }
  CHECK_THAT(error_of(with(valid("pairs"), {"--broadphase", "magic"})), Contains("--broadphase: found magic, allowed"));
}

TEST_CASE("methods and backends that bench cannot measure are refused with those that it can") {
  const std::string methods = ", allowed brute-force, ";
  check_all({
      {{"bench", "--methods", "magic"}, "--methods: found magic" + methods},
      {{"bench", "--methods", "auto"}, "--methods: found auto" + methods},
      {{"bench", "--methods", "brute-force,"}, "--methods: found nothing" + methods},
      {{"bench", "--methods", "brute-force linked-cell"}, "--methods: found brute-force linked-cell" + methods},
      {{"bench", "--backends", "auto"}, "--backends: found auto, allowed cpu, cuda"},
      {{"bench", "--backends", ","}, "--backends: found nothing, allowed cpu, cuda"},
      {{"bench", "--counts", "100,,200"}, "--counts: found nothing, allowed an integer from 1"},
      {{"bench", "--counts", "100;200"}, "--counts: found 100;200, allowed an integer from 1"},
  });
  const std::string reason = cuda_backend().unavailable_reason;
  if (reason.empty()) return;
  CHECK_THAT(error_of({"bench", "--backends", "cpu,cuda"}), Contains("--backends: found cuda, ") && Contains(reason));
}

TEST_CASE("sizes that are none are refused") {
  for (const char* size : {"640x", "x360", "640", "640x360x3", "640X360", "8x8", "99999x16", "640x-360", "1e3x16"}) {
    CHECK_THAT(error_of(with(valid("render"), {"--size", size})),
               Contains("--size: found " + std::string(size) + ", allowed WIDTHxHEIGHT, each from 16 to 16384"));
  }
}

TEST_CASE("overlays and themes that do not exist are refused with those that do") {
  for (const char* overlays : {"magic", "", "grid,", ",grid", "grid,magic", "none,grid", "grid grid"}) {
    CHECK_THAT(error_of(with(valid("render"), {"--overlay", overlays})),
               Contains("--overlay: found ") && Contains(", allowed none alone, or some of grid"));
  }
  CHECK_THAT(error_of(with(valid("render"), {"--theme", "magic"})),
             Contains("--theme: found magic, allowed projector, dark"));
  CHECK_THAT(error_of(with(valid("render"), {"--theme", ""})),
             Contains("--theme: found nothing, allowed projector, dark"));
  CHECK_THAT(error_of(with(valid("render"), {"--panel", "--ui-scale", "9"})),
             Contains("--ui-scale: found 9, allowed a number from 0.5 to 3"));
  CHECK_THAT(error_of({"show", "--ui-scale", "nan"}),
             Contains("--ui-scale: found nan, allowed a number from 0.5 to 3"));
  CHECK_THAT(error_of(with(valid("render"), {"--ui-scale", "2"})),
             Contains("--ui-scale: found without --panel, allowed together with it"));
}

TEST_CASE("observables that do not exist are refused with those that do") {
  for (const char* observables :
       {"magic", "", "pressure,", ",pressure", "pressure,magic", "all,pressure", "Pressure"}) {
    const std::string error = error_of(with(valid("simulate"), {"--observe", observables}));
    CHECK_THAT(error, Contains("--observe: found ") && Contains(", allowed all alone, or some of kinetic-energy, "));
    for (const Observable& observable : ballpit::observables())
      CHECK_THAT(error, Contains(std::string(observable.name)));
  }
  CHECK_THAT(error_of({"simulate", "nosuch", "--observe", "magic"}), Contains("--observe: found magic"));
}

TEST_CASE("a trajectory needs a path of its own, and steps between frames need a trajectory") {
  check_all({
      {{"simulate", "--trajectory"}, "--trajectory: found nothing, allowed FILE"},
      {{"simulate", "--trajectory", ""}, "--trajectory: found nothing, allowed a path"},
      {{"simulate", "--trajectory", "x", "--out", "x"},
       "--trajectory: found x, which is --out as well, allowed a file of its own"},
      {{"simulate", "--every", "5"}, "--every: found 5 without --trajectory, allowed together with it"},
      {{"simulate", "--trajectory", "x", "--every", "0"}, "--every: found 0, allowed an integer from 1 to 1000000000"},
  });
}

TEST_CASE("more steps than can be counted are refused, in place of none being made") {
  CHECK_THAT(error_of({"simulate", "two-spheres", "--time", "1e9", "--dt", "1e-12"}),
             Contains("--dt: found 1e-12") && Contains("1e+21 steps"));
  const Scratch scratch;
  error_of({"simulate", "two-spheres", "--time", "1e9", "--dt", "1e-12", "--trajectory", scratch / "a.xyz"});
  CHECK(std::filesystem::is_empty(scratch.path()));
}

TEST_CASE("an option that does not go with the response is refused with those that do, in one line") {
  const auto refusal = [](const char* response, const char* option, const char* value, const std::string& message) {
    return Wrong{{"simulate", "two-spheres", "--time", "0", "--response", response, option, value},
                 option + (": found " + (value + (", allowed " + message))) + "\n"};
  };
  check_all({
      refusal("impulse", "--integrator", "rk4", "symplectic-euler with --response impulse"),
      refusal("kinematic", "--integrator", "velocity-verlet", "symplectic-euler with --response kinematic"),
      refusal("position-based", "--integrator", "velocity-verlet", "symplectic-euler with --response position-based"),
      refusal("penalty", "--integrator", "exact",
              "velocity-verlet, symplectic-euler, explicit-euler, rk4 with --response penalty"),
      refusal("event-driven", "--integrator", "velocity-verlet", "exact with --response event-driven"),
      refusal("event-driven", "--backend", "cuda", "auto, cpu with --response event-driven"),
      refusal("event-driven", "--precision", "float", "double with --response event-driven"),
      refusal("penalty", "--iterations", "5", "with --response impulse, position-based, not penalty"),
      refusal("kinematic", "--iterations", "5", "with --response impulse, position-based, not kinematic"),
      refusal("position-based", "--solver", "jacobi", "with --response impulse, not position-based"),
      refusal("impulse", "--contact-end", "force", "with --response penalty, not impulse"),
      refusal("impulse", "--compliance", "1e-4", "with --response position-based, not impulse"),
      refusal("position-based", "--correction", "none", "with --response impulse, not position-based"),
      refusal("impulse", "--contact-duration", "1e-6", "with --response event-driven, not impulse"),
      refusal("penalty", "--swept", "on", "with --response kinematic, impulse, not penalty"),
      refusal("event-driven", "--swept", "on", "with --response kinematic, impulse, not event-driven"),
  });
  // Against the response that the scene presets, and by render as well.
  CHECK_THAT(error_of({"simulate", "two-spheres", "--integrator", "rk4"}), Contains("with --response impulse"));
  CHECK_THAT(error_of(with(valid("render"), {"--contact-end", "force"})), Contains("--contact-end: found force"));
}

TEST_CASE("a backend without a device is refused with the reason") {
  const std::string reason = cuda_backend().unavailable_reason;
  if (reason.empty()) {
    WARN("a CUDA device answers: nothing to refuse");
    return;
  }
  CHECK_THAT(error_of(with(valid("simulate"), {"--backend", "cuda"})),
             Contains("--backend: found cuda") && Contains(reason) && Contains("allowed auto, cpu"));
}

TEST_CASE("line breaks in what was found do not break the line") {
  CHECK_THAT(error_of({"simulate", "a\nb.toml"}), Contains("a?b.toml: found no readable file"));
  CHECK_THAT(error_of({"simulate", "--dt", "1\n2"}), Contains("--dt: found 1?2"));
}

TEST_CASE("a scene that does not exist is refused with those that do") {
  const std::string error = error_of({"simulate", "nosuch"});
  CHECK_THAT(error, Contains("SCENE: found \"nosuch\", allowed "));
  for (const SceneInfo& scene : built_in_scenes()) CHECK_THAT(error, Contains(scene.name));
  CHECK_THAT(error_of({"render", "nosuch", "--out", "/proc/nowhere"}), Contains("SCENE: found \"nosuch\""));
  CHECK_THAT(error_of({"simulate", ""}), Contains("SCENE: found \"\""));
  CHECK_THAT(error_of({"simulate", "nosuch.toml"}), Contains("nosuch.toml: found no readable file (No such file"));
  CHECK_THAT(error_of({"simulate", "/nowhere/x.toml"}),
             Contains("/nowhere/x.toml: found no readable file (No such file"));
  CHECK_THAT(error_of({"simulate", "/tmp/"}), Contains("/tmp/: found a folder, allowed a file"));
}
