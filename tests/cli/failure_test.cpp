// SPDX-License-Identifier: MIT
// Runs that cannot go on: status 1, one line with the reason, nothing half written.
#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "render/gl_context.h"
#include "tests/support/run_program.h"

using namespace ballpit;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// Runs what fails; returns its one line, without the warnings of a run that cannot work before it.
std::string failure_of(const Arguments& arguments, const Circumstances& circumstances = {}) {
  const Outcome outcome = run_program(arguments, circumstances);
  INFO(outcome.err);
  CHECK(outcome.status == 1);
  CHECK(outcome.out.empty());
  std::string error = outcome.err;
  while (error.starts_with("ballpit: warning: ")) error.erase(0, error.find('\n') + 1);
  CHECK(std::count(error.begin(), error.end(), '\n') == 1);
  return error;
}

std::string failure_to_render(const std::string& out, const std::string& frames = "4") {
  return failure_of({"render", "two-spheres", "--size", "64x36", "--frames", frames, "--out", out});
}

std::string failure_to_write(const std::string& out) {
  return failure_of({"simulate", "two-spheres", "--time", "0", "--out", out});
}

/// A machine that lacks these libraries: they are found, but empty.
class Lacking {
 public:
  explicit Lacking(const std::vector<std::string>& libraries) : path_("LD_LIBRARY_PATH", folder_.path().string()) {
    for (const std::string& library : libraries) write_text(folder_ / library, "");
  }

 private:
  const Scratch folder_;
  const Variable path_;
};

}  // namespace

TEST_CASE("a folder that cannot be made is named with the reason") {
  const Scratch scratch;
  write_text(scratch / "file", "x");
  CHECK_THAT(failure_to_render(scratch / "file/film"), Contains("file/film") && Contains("Not a directory"));
  CHECK_THAT(failure_to_render(scratch / "file"), Contains("file"));
  CHECK_THAT(failure_to_render("/proc/nowhere"), Contains("/proc/nowhere"));
  CHECK(read_text(scratch / "file") == "x");
}

TEST_CASE("a state that cannot be written is named with the reason") {
  const Scratch scratch;
  write_text(scratch / "file", "x");
  CHECK_THAT(failure_to_write(scratch / "file/state.csv"), Contains("file/state.csv") && Contains("Not a directory"));
  CHECK_THAT(failure_to_write(scratch / "missing/state.csv"), Contains("No such file"));
  CHECK_THAT(failure_to_write("/proc/state.csv"), Contains("/proc/state.csv"));
  CHECK_THAT(failure_to_write(scratch.path().string()), Contains(scratch.path().string()));
}

TEST_CASE("a full disk is named with the file that found no room, and leaves whole files only") {
  if (!fs::exists("/dev/full")) return;
  const Scratch scratch;
  const Circumstances small{0, "", "", 100};
  CHECK_THAT(failure_of({"simulate", "two-spheres", "--time", "0", "--out", scratch / "state.csv"}, small),
             Contains("state.csv: cannot write: File too large"));
  CHECK(fs::is_empty(scratch.path()));

  fs::create_symlink("/dev/full", scratch / "frame_00002.png");
  CHECK_THAT(failure_to_render(scratch.path().string()), Contains("frame_00002.png: cannot write: No space left"));
  CHECK(fs::exists(scratch / "frame_00001.png"));
  CHECK(fs::is_symlink(scratch / "frame_00002.png"));
  CHECK_FALSE(fs::exists(scratch / "frame_00002.png.part"));

  fs::remove(scratch / "frame_00000.png");
  fs::create_symlink("/dev/full", scratch / "frame_00000.png");
  CHECK_THAT(failure_to_render(scratch.path().string(), "100"),
             Contains("frame_00000.png") && Contains("No space left"));
}

TEST_CASE("an output that cannot be written is reported before the run") {
  const Scratch scratch;
  CHECK_THAT(failure_of({"simulate", "--time", "1e6", "--out", "/nonexistent/x.csv"}),
             Contains("/nonexistent/x.csv: cannot write: No such file"));
  CHECK_THAT(failure_of({"simulate", "--time", "1e6", "--trajectory", "/nonexistent/x.xyz"}), Contains("No such file"));
  CHECK_THAT(failure_of({"render", "--from", "1e6", "--out", "/proc/film"}), Contains("/proc/film: cannot make"));
  CHECK_THAT(failure_of({"simulate", "/nonexistent.toml", "--out", "/nonexistent/x.csv"}), Contains("x.csv: cannot"));
}

TEST_CASE("two outputs, or an output and the input, are not the same file") {
  const Scratch scratch;
  const auto refusal_of = [&](const std::vector<std::string>& arguments) {
    const Outcome outcome = run_program(arguments);
    CHECK(outcome.status == 2);
    return outcome.err;
  };
  fs::create_symlink("a", scratch / "b");
  CHECK_THAT(refusal_of({"simulate", "two-spheres", "--out", scratch / "a", "--trajectory", scratch / "b"}),
             Contains("--trajectory: found " + scratch / "b" + ", which is --out as well, allowed a file of its own"));
  write_text(scratch / "s.toml", "[[spheres]]\n");
  CHECK_THAT(refusal_of({"simulate", scratch / "s.toml", "--out", scratch / "s.toml"}),
             Contains("--out: found ") && Contains("which is SCENE as well"));
  write_text(scratch / "s.csv", "x,y,z,radius\n0,0,0,1\n");
  CHECK_THAT(refusal_of({"pairs", scratch / "s.csv", "--out", scratch / "s.csv"}), Contains("which is FILE as well"));
  CHECK(read_text(scratch / "s.csv") == "x,y,z,radius\n0,0,0,1\n");
}

TEST_CASE("a state goes into standard output where it is asked to, before the summary") {
  const Scratch scratch;
  const Outcome outcome = run_program({"simulate", "lecture-grid", "--time", "0", "--out", "/dev/stdout"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::StartsWith("x,y,") && Contains("lecture-grid"));
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), ',') >= 20 * 7);
}

TEST_CASE("a summary that cannot be written is a failure") {
  if (!fs::exists("/dev/full")) return;
  const Circumstances full{0, "/dev/full"};
  CHECK_THAT(failure_of({"simulate", "two-spheres", "--json"}, full),
             Contains("standard output: cannot write: No space"));
  CHECK_THAT(failure_of({"list"}, full), Contains("standard output"));
  CHECK_THAT(failure_of({"doctor", "--json"}, full), Contains("standard output"));
  CHECK_THAT(failure_of({"--help"}, full), Contains("standard output"));
}

TEST_CASE("a lack of memory is reported, with a hint that needs less") {
  if (is_sanitized()) return;
  const Scratch scratch;
  write_text(scratch / "many.toml", "[[fill]]\ncount = 8000000\nradius = 0.002\narrangement = 'lattice'\n");
  for (const uint64_t megabytes : {200, 400, 800}) {
    INFO(megabytes << " MB");
    CHECK_THAT(failure_of({"simulate", scratch / "many.toml", "--time", "0"}, {megabytes * 1'000'000, ""}),
               Contains("out of memory") && Contains("--count"));
  }
}

TEST_CASE("a lack of memory for a picture is reported, in OpenGL and in the program") {
  if (is_sanitized() || !GlContext().info().software) return;  // a graphics device has memory of its own
  const Scratch scratch;
  const std::vector<std::string> huge{"render",   "two-spheres", "--size", "16384x16384",
                                      "--frames", "1",           "--out",  scratch / "film"};
  CHECK_THAT(failure_of(huge, {1'200'000'000, ""}), Contains("16384x16384") && Contains("GL_OUT_OF_MEMORY"));
  CHECK_THAT(failure_of(huge, {3'400'000'000, ""}), Contains("out of memory") && Contains("--size"));
  const Outcome larger = run_program({"render", "two-spheres", "--size", "16384x16384", "--supersample", "4",
                                      "--frames", "1", "--out", scratch / "film"});
  CHECK(larger.status == 2);
  CHECK_THAT(larger.err, Contains("--size: found 65536x65536 pixels, supersampling included, allowed sides of 1 to "));
}

TEST_CASE("a sphere that leaves the domain stops the run with its number and the step") {
  CHECK_THAT(failure_of({"simulate", "bouncing-balls", "--count", "50", "--time", "100", "--dt", "2"}),
             Contains("step ") && Contains("sphere ") && Contains("left the domain") && Contains("--dt"));
  const Scratch scratch;
  CHECK_THAT(failure_of({"render", "bouncing-balls", "--count", "50", "--dt", "2", "--fps", "0.5", "--size", "64x36",
                         "--frames", "9", "--out", scratch.path().string()}),
             Contains("left the domain"));
  CHECK(fs::exists(scratch / "frame_00000.png"));
}

TEST_CASE("without OpenGL's libraries, doctor says what is missing, and render and show name the package") {
  const Variable no_display("DISPLAY", ""), no_wayland("WAYLAND_DISPLAY", "");
  for (const auto& [libraries, package] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"libEGL.so.1"}, "libegl1"},
           {{"libGL.so.1"}, "libgl1"},
           {{"libGL.so.1", "libOpenGL.so.0"}, "libgl1"},
           {{"libGLX.so.0"}, "libgl1"},
           {{"libGLdispatch.so.0"}, "libegl1"},
           {{"libEGL.so.1", "libGL.so.1", "libOpenGL.so.0"}, "libegl1"}}) {
    INFO(libraries.front());
    const Lacking lacking(libraries);
    const Outcome doctor = run_program({"doctor"});
    CHECK(doctor.status == 0);
    CHECK(doctor.err.empty());
    CHECK_THAT(doctor.out, Contains("OpenGL        not here: ") && Contains("on Debian, the package " + package));
    CHECK(run_program({"doctor", "--json"}).json()["gl"].contains("error"));
    const Scratch scratch;
    CHECK_THAT(failure_to_render(scratch / "film"), Contains("no OpenGL") && Contains("the package " + package));
    CHECK_THAT(failure_of({"show", "two-spheres"}),
               Contains("show: no window: ") && Contains("on Debian, the package "));
    CHECK(run_program({"simulate", "two-spheres", "--time", "0"}).status == 0);
  }
}
