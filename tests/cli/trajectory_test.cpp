// SPDX-License-Identifier: MIT
// simulate --trajectory: which states become frames, and what is kept of runs that end early.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <thread>

#include <catch2/catch.hpp>

#include "scene/spheres_csv.h"
#include "tests/support/run_program.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A run that stops after a third of a second or so, since its steps are too large for the walls.
const Arguments kHalting{"simulate", "bouncing-balls", "--dt", "0.01", "--time", "3"};

Outcome run_to_end(const Arguments& arguments) {
  const Outcome outcome = run_program(arguments);
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  return outcome;
}

/// Runs what fails; returns its one line.
std::string sole_line_of(const Arguments& arguments, const Circumstances& circumstances = {}) {
  const Outcome outcome = run_program(arguments, circumstances);
  INFO(outcome.err);
  CHECK(outcome.status == 1);
  CHECK(outcome.out.empty());
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  return outcome.err;
}

/// The times of a trajectory's frames [s]. Fails where a frame is not whole.
std::vector<double> times_in(const std::string& path) {
  std::istringstream in(read_text(path));
  std::vector<double> times;
  for (std::string line; std::getline(in, line);) {
    const int count = std::stoi(line);
    REQUIRE(std::getline(in, line));
    times.push_back(std::stod(line.substr(line.find(" Time=") + 6)));
    for (int i = 0; i < count; ++i) {
      REQUIRE(std::getline(in, line));
      CHECK(std::count(line.begin(), line.end(), ' ') == 8);
    }
    CHECK_FALSE(in.eof());  // the last line ends
  }
  return times;
}

void check_times(const std::vector<double>& times, const std::vector<double>& expected) {
  REQUIRE(times.size() == expected.size());
  for (size_t k = 0; k < times.size(); ++k) CHECK(times[k] == Approx(expected[k]));
}

int64_t files_in(const Scratch& folder) {
  return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator{});
}

}  // namespace

TEST_CASE("a trajectory has every step from the start to the end") {
  const Scratch folder;
  run_to_end({"simulate", "two-spheres", "--dt", "0.1", "--time", "0.3", "--trajectory", folder / "a.xyz"});
  check_times(times_in(folder / "a.xyz"), {0, 0.1, 0.2, 0.3});
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a trajectory of every nth step ends with the end, once") {
  const Scratch folder;
  const Arguments run{"simulate", "two-spheres", "--dt", "0.1", "--trajectory", folder / "a.xyz", "--every", "3"};
  run_to_end(with(run, {"--time", "0.7"}));
  check_times(times_in(folder / "a.xyz"), {0, 0.3, 0.6, 0.7});
  run_to_end(with(run, {"--time", "0.6"}));
  check_times(times_in(folder / "a.xyz"), {0, 0.3, 0.6});
  run_to_end(with(run, {"--time", "0"}));
  check_times(times_in(folder / "a.xyz"), {0});
}

TEST_CASE("the last frame is the final state, and the frames change nothing that is simulated") {
  const Scratch folder;
  const Arguments run{"simulate", "bouncing-balls", "--count", "50", "--time", "0.2", "--json"};
  const nlohmann::json alone = run_to_end(run).json();
  const nlohmann::json watched =
      run_to_end(with(run, {"--out", folder / "a.csv", "--trajectory", folder / "a.xyz"})).json();
  CHECK(watched["state_hash"] == alone["state_hash"]);
  const std::string text = read_text(folder / "a.xyz"), csv = read_text(folder / "a.csv");
  // The last line of either: species x y z radius vx vy vz mass, and the same without species.
  std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
  std::replace(last.begin(), last.end(), ',', ' ');
  CHECK_THAT(text, Catch::EndsWith("\nX " + last));
}

TEST_CASE("a trajectory that cannot be written is reported before the first step") {
  CHECK_THAT(sole_line_of({"simulate", "bouncing-balls", "--time", "1e6", "--trajectory", "/nonexistent/a.xyz"}),
             Contains("/nonexistent/a.xyz: cannot write: No such file or directory"));
}

TEST_CASE("Ctrl-C and closing the terminal keep the frames so far, and say where") {
  const int signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
  const Scratch folder;
  Program program({"simulate", "bouncing-balls", "--count", "100", "--time", "1e6", "--every", "100", "--trajectory",
                   folder / "a.xyz"});
  std::error_code missing;
  while (fs::file_size(folder / "a.xyz.part", missing) < 40'000 || missing) {  // more than two frames
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.signal(signal);
  if (signal == SIGHUP) program.signal(signal);  // the shell sends one as well
  const Outcome outcome = program.wait();
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("interrupted after ") && Contains(" so far ") && Contains("in " + folder / "a.xyz"));
  const std::vector<double> times = times_in(folder / "a.xyz");
  CHECK_FALSE(times.empty());
  for (size_t k = 0; k < times.size(); ++k) CHECK(times[k] == Approx(static_cast<double>(100 * k) / 240));
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a disk that fills up leaves the whole frames before, and the last state, and says so") {
  const Scratch folder;
  const Circumstances little{0, "", folder.path().string(), 10'000};
  const std::string error = sole_line_of(
      {"simulate", "bouncing-balls", "--count", "20", "--dt", "0.001", "--time", "1", "--trajectory", "a.xyz"}, little);
  CHECK_THAT(error, Contains("ballpit: a.xyz: cannot write: File too large; the last good state, of t = ") &&
                        Contains("is in bouncing-balls-last-good.csv; the ") &&
                        Contains(" frames so far are in a.xyz"));
  const std::vector<double> times = times_in(folder / "a.xyz");
  CHECK(times.size() >= 2);
  CHECK(fs::file_size(folder / "a.xyz") <= 10'000);
  CHECK_THAT(error, Contains("the " + std::to_string(times.size()) + " frames"));
  CHECK(read_spheres_csv(LineReader(folder / "bouncing-balls-last-good.csv")).size() == 20);
  CHECK(files_in(folder) == 2);
}

TEST_CASE("a run that fails leaves its last good state beside it, and says of which time and where") {
  const Scratch folder;
  const std::string error = sole_line_of(kHalting, {0, "", folder.path().string()});
  CHECK_THAT(error, Catch::StartsWith("ballpit: step ") && Contains("; the last good state, of t = 0.") &&
                        Catch::EndsWith(" s, is in bouncing-balls-last-good.csv\n"));
  const Bodies bodies = read_spheres_csv(LineReader(folder / "bouncing-balls-last-good.csv"));
  CHECK(bodies.size() == 2000);
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a run that fails while it is drawn leaves its last good state as well") {
  const Scratch folder;
  Arguments arguments = kHalting;
  arguments[0] = "render";
  if (const auto time = std::find(arguments.begin(), arguments.end(), "--time"); time != arguments.end()) {
    arguments.erase(time, time + 2);
  }
  const Arguments picture{"--out", folder / "frames", "--frames", "100", "--fps", "10", "--size", "64x36"};
  const std::string error = sole_line_of(with(arguments, picture), {0, "", folder.path().string()});
  CHECK_THAT(error, Catch::StartsWith("ballpit: step ") && Catch::EndsWith(" s, is in bouncing-balls-last-good.csv\n"));
  CHECK(read_spheres_csv(LineReader(folder / "bouncing-balls-last-good.csv")).size() == 2000);
}

TEST_CASE("a run that fails leaves its last good state where the final one was to be") {
  const Scratch folder, nothing;
  CHECK_THAT(sole_line_of(with(kHalting, {"--out", folder / "state.csv"}), {0, "", nothing.path().string()}),
             Contains(" s, is in " + folder / "state.csv"));
  CHECK(read_spheres_csv(LineReader(folder / "state.csv")).size() == 2000);
  CHECK(files_in(folder) == 1);
  CHECK(files_in(nothing) == 0);
}

TEST_CASE("if the last good state cannot be written, both errors are reported") {
  if (!fs::exists("/dev/full")) return;
  const Scratch folder;
  fs::create_symlink("/dev/full", folder / "state.csv");
  CHECK_THAT(sole_line_of(with(kHalting, {"--out", folder / "state.csv"})),
             Catch::StartsWith("ballpit: step ") &&
                 Contains(" s, is lost: " + folder / "state.csv" + ": cannot write: No space left on device"));
}

TEST_CASE("a run that fails keeps its frames") {
  const Scratch folder;
  const std::string error =
      sole_line_of(with(kHalting, {"--out", folder / "state.csv", "--trajectory", folder / "a.xyz", "--every", "10"}));
  const std::vector<double> times = times_in(folder / "a.xyz");
  CHECK(times.size() >= 2);
  for (size_t k = 0; k < times.size(); ++k) CHECK(times[k] == Approx(0.1 * static_cast<double>(k)).margin(1e-12));
  CHECK_THAT(error, Contains("is in " + (folder / "state.csv") + "; the " + std::to_string(times.size()) +
                             " frames so far are in " + (folder / "a.xyz")));
}
