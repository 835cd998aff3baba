// SPDX-License-Identifier: MIT
// Films that are cut off: what is there is whole, and --resume completes it to the same bytes.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <catch2/catch.hpp>

#include "export/frame_sequence.h"
#include "export/png.h"
#include "tests/support/run_program.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

Arguments render_balls(const std::string& out, int frames, const Arguments& options = {}) {
  return with({"render", "bouncing-balls", "--count", "150", "--size", "160x90", "--frames", std::to_string(frames),
               "--out", out},
              options);
}

Outcome render_whole(const std::string& out, int frames, const Arguments& options = {}) {
  Outcome outcome = run_program(render_balls(out, frames, options));
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  return outcome;
}

std::string frame(const Scratch& folder, int index) { return folder / frame_name(index); }

/// Waits until the film has `count` frames; false if it takes more than a minute.
bool wait_for_frames(const Scratch& folder, int count) {
  for (int k = 0; k < 6000; ++k) {
    if (fs::exists(frame(folder, count - 1))) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/// Frames on disk without a gap from the first; fails where one is not whole, or something else lies there.
int count_whole_frames(const Scratch& folder, bool allow_parts) {
  int count = 0;
  for (; fs::exists(frame(folder, count)); ++count) CHECK(is_whole_png(read_text(frame(folder, count))));
  int others = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    others += !(allow_parts && entry.path().extension() == ".part");
  }
  CHECK(others == count);
  return count;
}

void check_same_frames(const Scratch& a, const Scratch& b, int count) {
  for (int k = 0; k < count; ++k) {
    INFO("frame " << k);
    const bool is_same = read_text(frame(a, k)) == read_text(frame(b, k));  // not in CHECK, which would print the bytes
    CHECK(is_same);
  }
}

constexpr int kMany = 400;  // more than are made before the signal comes

/// Cuts a film off by a signal and completes it; compares with a film made at a stretch.
void cut_and_resume(int signal, const Scratch& folder, Outcome& cut) {
  Program program(render_balls(folder.path().string(), kMany));
  REQUIRE(wait_for_frames(folder, 3));
  program.signal(signal);
  cut = program.wait();
  const int made = count_whole_frames(folder, signal == SIGKILL);
  CHECK(made >= 3);
  REQUIRE(made < kMany);
  const int goal = made + 4;
  CHECK(render_whole(folder.path().string(), goal, {"--resume", "--json"}).json()["rendered"] == 4);
  const Scratch whole;
  render_whole(whole.path().string(), goal);
  check_same_frames(folder, whole, goal);
  CHECK(count_whole_frames(folder, false) == goal);
}

}  // namespace

TEST_CASE("the option --resume completes a film that lost its end to the same bytes") {
  const Scratch whole, cut;
  render_whole(whole.path().string(), 12);
  render_whole(cut.path().string(), 12);
  for (int k = 9; k < 12; ++k) fs::remove(frame(cut, k));
  fs::resize_file(frame(cut, 8), fs::file_size(frame(cut, 8)) / 2);
  write_text(frame(cut, 9) + ".part", "half");
  CHECK(render_whole(cut.path().string(), 12, {"--resume", "--json"}).json()["rendered"] == 4);
  check_same_frames(cut, whole, 12);
  CHECK(count_whole_frames(cut, false) == 12);
}

TEST_CASE("the option --resume of a film without a gap makes nothing, and of none makes all") {
  const Scratch folder;
  CHECK(render_whole(folder / "film", 3, {"--resume", "--json"}).json()["rendered"] == 3);
  CHECK(render_whole(folder / "film", 3, {"--resume", "--json"}).json()["rendered"] == 0);
}

TEST_CASE("Ctrl-C leaves whole frames, status 1 and a line that names --resume") {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Scratch folder;
    Outcome cut;
    cut_and_resume(signal, folder, cut);
    CHECK(cut.status == 1);
    CHECK(cut.out.empty());
    CHECK_THAT(cut.err, Contains("interrupted after ") && Contains("of 400 frames") && Contains("--resume"));
    CHECK(std::count(cut.err.begin(), cut.err.end(), '\n') == 1);
  }
}

TEST_CASE("killing the program leaves whole frames, beside one that --resume clears away") {
  const Scratch folder;
  Outcome cut;
  cut_and_resume(SIGKILL, folder, cut);
  CHECK(cut.status == 128 + SIGKILL);
}

TEST_CASE("a new film that is cut off does not go on with frames of the one before") {
  const Scratch folder;
  render_whole(folder.path().string(), 200, {"--theme", "dark"});
  Program program(render_balls(folder.path().string(), 200));
  const std::string first = read_text(frame(folder, 1));
  while (!fs::exists(frame(folder, 1)) || read_text(frame(folder, 1)) == first) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.signal(SIGINT);
  const Outcome cut = program.wait();
  CHECK(cut.status == 1);
  const int made = count_whole_frames(folder, false);
  CHECK(made < 200);
  render_whole(folder.path().string(), made + 2, {"--resume"});
  const Scratch whole;
  render_whole(whole.path().string(), made + 2);
  check_same_frames(folder, whole, made + 2);
}

TEST_CASE("frames of an earlier, longer film are reported and kept") {
  const Scratch folder;
  render_whole(folder.path().string(), 6);
  const Outcome outcome = render_whole(folder.path().string(), 4);
  CHECK_THAT(outcome.err, Contains("frame_00004.png to frame_00005.png") && Contains("earlier run"));
  CHECK(fs::exists(frame(folder, 5)));
  CHECK(render_whole(folder.path().string(), 6).err.empty());
}

TEST_CASE("Ctrl-C ends simulate with status 1 and the steps made, without a state, and so does closing the terminal") {
  for (const int signal : {SIGINT, SIGHUP}) {
    const Scratch folder;
    Program program({"simulate", "bouncing-balls", "--count", "100", "--time", "1e6", "--out", folder / "state.csv"});
    REQUIRE(program.wait_until_it_catches(signal));
    program.signal(signal);
    const Outcome outcome = program.wait();
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err, Contains("interrupted after ") && Contains(" steps, at t = "));
    CHECK(fs::is_empty(folder.path()));
  }
}

TEST_CASE("Ctrl-C takes effect within one long step of event-driven motion, and leaves no state") {
  const Scratch folder;
  Program program({"simulate", "bouncing-balls", "--count", "5000", "--response", "event-driven", "--dt", "10",
                   "--time", "10", "--out", folder / "state.csv"});
  REQUIRE(program.wait_until_it_catches(SIGINT));
  program.signal(SIGINT);
  const Outcome outcome = program.wait();
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("interrupted after 0 of 1 steps, at t = "));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("the option --resume refuses frames that show something else, and says what") {
  const Scratch folder;
  const std::string out = folder.path().string();
  render_whole(out, 2);
  const std::string first = read_text(frame(folder, 0));
  const auto check_refused = [&](const Arguments& arguments, const std::string& what) {
    INFO(what);
    const Outcome outcome = run_program(arguments);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("--resume: found frame_00000.png in " + out + " with " + what) &&
                                Contains(", allowed frames with "));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(count_whole_frames(folder, false) == 2);
    CHECK((read_text(frame(folder, 0)) == first));
  };
  check_refused({"render", "lecture-grid", "--size", "160x90", "--out", out, "--resume"}, "scene bouncing-balls");
  check_refused({"render", "bouncing-balls", "--count", "150", "--size", "80x90", "--out", out, "--resume"},
                "size 160x90");
  for (const auto& [options, what] :
       std::vector<std::pair<Arguments, std::string>>{{{"--theme", "dark"}, "theme "},
                                                      {{"--overlay", "none"}, "overlay "},
                                                      {{"--color", "size"}, "color "},
                                                      {{"--seed", "7"}, "state "},
                                                      {{"--from", "1"}, "from 0"},
                                                      {{"--fps", "30"}, "interval "},
                                                      {{"--every", "2"}, "interval "},
                                                      {{"--supersample", "2"}, "supersample 1"},
                                                      {{"--panel"}, "panel none"},
                                                      {{"--turn", "6"}, "turn 0"},
                                                      {{"--caption", "on"}, "caption off"},
                                                      {{"--dt", "0.001"}, "dt "},
                                                      {{"--swept", "on"}, "swept "}}) {
    Arguments arguments = render_balls(out, 4, options);
    arguments.emplace_back("--resume");
    check_refused(arguments, what);
  }
  render_whole(out, 3, {"--resume", "--threads", "1"});  // changes no picture
  CHECK(count_whole_frames(folder, false) == 3);
}

TEST_CASE("a film that compares methods goes on with its counts, and refuses frames that compare others") {
  const Scratch folder, whole;
  const auto compared = [](const Scratch& out, int frames, const std::string& methods, bool resumes) {
    Arguments arguments{"render",    "bouncing-balls",
                        "--count",   "150",
                        "--size",    "320x180",
                        "--turn",    "30",
                        "--frames",  std::to_string(frames),
                        "--out",     out.path().string(),
                        "--compare", methods};
    if (resumes) arguments.emplace_back("--resume");
    return run_program(arguments);
  };
  CHECK(compared(folder, 2, "brute-force,linked-cell", false).status == 0);
  CHECK(compared(folder, 4, "brute-force,linked-cell", true).status == 0);
  CHECK(compared(whole, 4, "brute-force,linked-cell", false).status == 0);
  check_same_frames(folder, whole, 4);
  const Outcome other = compared(folder, 5, "brute-force,sorted-grid", true);
  CHECK(other.status == 2);
  CHECK_THAT(other.err, Contains(" with compare brute-force,linked-cell, allowed frames with compare brute-force,so"));
}

TEST_CASE("frames of older versions, which do not say what they show, are refused where their size is another") {
  const Scratch folder;
  for (int k = 0; k < 2; ++k) {
    write_text(frame(folder, k), encode_png({160, 90, std::vector<uint8_t>(160 * 90 * 4, 9)}));
  }
  CHECK(render_whole(folder.path().string(), 3, {"--resume", "--json"}).json()["rendered"] == 1);
  write_text(frame(folder, 1), encode_png({80, 90, std::vector<uint8_t>(80 * 90 * 4, 9)}));
  Arguments again = render_balls(folder.path().string(), 4, {"--resume"});
  const Outcome outcome = run_program(again);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err,
             Contains("found frame_00001.png in ") && Contains(" with size 80x90, allowed frames with size 160x90"));
}
