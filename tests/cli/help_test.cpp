// SPDX-License-Identifier: MIT
// The help, the lists and the documentation name everything that the program's tables hold.
#include <algorithm>
#include <filesystem>
#include <sstream>

#include <catch2/catch.hpp>

#include "lab/report/experiment.h"
#include "methods/methods.h"
#include "methods/settings.h"
#include "render/coloring.h"
#include "render/overlays/overlay.h"
#include "render/theme.h"
#include "scene/read_scene.h"
#include "show/options.h"
#include "tests/support/run_program.h"
#include "world/observables.h"
#include "world/world.h"

using namespace ballpit;
using Catch::Contains;

namespace {

std::vector<std::string> names_of(const nlohmann::json& list) {
  std::vector<std::string> names;
  for (const auto& entry : list) names.push_back(entry["name"]);
  return names;
}

/// The cells of the row of an option in the table of README or docs/command-line.md, without backquotes.
std::vector<std::string> documented(std::string_view option) {
  for (const char* file : {"/README.md", "/docs/command-line.md"}) {
    const std::string path = std::string(BALLPIT_SOURCE_DIR) + file;
    if (!std::filesystem::exists(path)) continue;
    std::istringstream text(read_text(path));
    for (std::string line; std::getline(text, line);) {
      if (!line.starts_with("| `--" + std::string(option) + "` |")) continue;
      line.erase(std::remove(line.begin(), line.end(), '`'), line.end());
      std::vector<std::string> cells;
      std::istringstream row(line.substr(2));
      for (std::string cell; std::getline(row, cell, '|');) {
        const size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
        cells.push_back(first == cell.npos ? "" : cell.substr(first, last - first + 1));
      }
      return cells;
    }
  }
  return {};
}

}  // namespace

TEST_CASE("the option --help names every command, and ends with status 0") {
  for (const char* option : {"--help", "-h"}) {
    const Outcome outcome = run_program({option});
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    for (const char* command : {"render", "simulate", "pairs", "bench", "lab", "list", "doctor"}) {
      CHECK_THAT(outcome.out, Contains(command));
    }
  }
}

TEST_CASE("the option --version is one line with a number") {
  const Outcome outcome = run_program({"--version"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Matches("ballpit [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_CASE("the help of render and simulate names every setting and its allowed values") {
  for (const char* command : {"render", "simulate"}) {
    const Outcome outcome = run_program({command, "--help"});
    CHECK(outcome.status == 0);
    for (const SettingInfo& setting : setting_table()) {
      CHECK_THAT(outcome.out, Contains("--" + std::string(setting.name) + " " + std::string(setting.value_name)));
      CHECK_THAT(outcome.out, Contains(std::string(setting.help) + ": " + setting.allowed));
    }
    CHECK_THAT(outcome.out, Contains(std::string(kDefaultScene)));
  }
}

TEST_CASE("the documentation names every setting with its allowed values and its default") {
  for (const SettingInfo& setting : setting_table()) {
    INFO("--" << setting.name);
    const std::vector<std::string> cells = documented(setting.name);
    REQUIRE(cells.size() == 4);
    CHECK(cells[1] == setting.allowed);
    CHECK(cells[2] == setting.preset);
  }
}

TEST_CASE("the help of render names every overlay and theme") {
  const Outcome outcome = run_program({"render", "--help"});
  for (const std::string& name : names_in(overlay_table())) CHECK_THAT(outcome.out, Contains(name));
  for (const std::string& name : names_in(themes())) CHECK_THAT(outcome.out, Contains(name));
}

TEST_CASE(
    "list --json is one object that holds every scene, method, backend, overlay, theme, observable and experiment") {
  const Outcome outcome = run_program({"list", "--json"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  const nlohmann::json list = outcome.json();
  CHECK(names_of(list["scenes"]) == names_in(built_in_scenes()));
  CHECK(names_of(list["overlays"]) == names_in(overlay_table()));
  CHECK(names_of(list["colorings"]) == names_in(coloring_table()));
  CHECK(names_of(list["themes"]) == names_in(themes()));
  CHECK(names_of(list["observables"]) == names_in(observables()));
  CHECK(names_of(list["experiments"]) == names_in(experiments()));
  for (const nlohmann::json& observable : list["observables"]) {
    for (const char* key : {"label", "unit", "planar_unit", "estimator"}) CHECK(observable[key].is_string());
  }
  CHECK(names_of(list["backends"]) == std::vector<std::string>{"cpu", "cuda"});
  size_t count = 0;
  for (const Method& method : methods()) {
    if (method.family == Family::backend) continue;
    REQUIRE(count < list["methods"].size());
    const nlohmann::json& entry = list["methods"][count++];
    CHECK(entry["name"] == method.name);
    CHECK(entry["family"] == name_of(method.family));
  }
  CHECK(list["methods"].size() == count);
}

TEST_CASE("list names for people what list --json names") {
  const Outcome outcome = run_program({"list"});
  CHECK(outcome.status == 0);
  for (const SceneInfo& scene : built_in_scenes())
    CHECK_THAT(outcome.out, Contains(scene.name) && Contains(scene.description));
  for (const Method& method : methods()) {
    if (method.name != "auto") CHECK_THAT(outcome.out, Contains(std::string(method.name)));
  }
  for (const std::string& name : names_in(overlay_table())) CHECK_THAT(outcome.out, Contains(name));
  for (const std::string& name : names_in(themes())) CHECK_THAT(outcome.out, Contains(name));
  for (const Observable& observable : observables()) {
    CHECK_THAT(outcome.out, Contains(std::string(observable.name)) && Contains(std::string(observable.estimator)));
  }
  for (const Experiment& experiment : experiments()) {
    CHECK_THAT(outcome.out, Contains(std::string(experiment.name)) && Contains(experiment.text().question));
  }
  CHECK_THAT(outcome.out, Contains("Pressure [Pa; in the plane N/m]: ") && Contains("Largest overlap: "));
}

TEST_CASE("the help of simulate names every observable") {
  const Outcome outcome = run_program({"simulate", "--help"});
  for (const std::string& name : names_in(observables())) CHECK_THAT(outcome.out, Contains(name));
}

TEST_CASE("the help of lab names every experiment") {
  const Outcome outcome = run_program({"lab", "--help"});
  for (const std::string& name : names_in(experiments())) CHECK_THAT(outcome.out, Contains(name));
}

TEST_CASE("doctor --json is one object that says what is available, or why it is not") {
  const Outcome outcome = run_program({"doctor", "--json"});
  CHECK(outcome.status == 0);
  const nlohmann::json found = outcome.json();
  CHECK(found["threads"] > 0);
  CHECK(found["version"].is_string());
  CHECK(found["tools"].contains("ffmpeg"));
  CHECK(found["tools"].contains("gnuplot"));
  CHECK(found["egl_devices"].is_array());
  CHECK((found["gl"].contains("renderer") || found["gl"].contains("error")));
  const std::string reason = cuda_backend().unavailable_reason;
  CHECK(found["cuda"]["available"] == reason.empty());
  CHECK(found["cuda"]["reason"] == reason);
}

TEST_CASE("doctor says the same for people") {
  const Outcome outcome = run_program({"doctor"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("CPU threads") && Contains("CUDA") && Contains("OpenGL") && Contains("ffmpeg") &&
                              Contains("gnuplot"));
}
