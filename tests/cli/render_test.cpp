// SPDX-License-Identifier: MIT
// ballpit render: whole pictures of the right states, the same bytes run after run.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <catch2/catch.hpp>

#include "tests/support/picture_compare.h"
#include "tests/support/run_program.h"

using namespace ballpit;
namespace fs = std::filesystem;

namespace {

/// Outside CHECK, which would print the bytes.
template <class Bytes>
bool is_same(const Bytes& a, const Bytes& b) {
  return a == b;
}

std::string frame(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "frame_%05d.png", index);
  return name;
}

/// The bytes of the frames of a small film of colliding balls.
std::vector<std::string> frames_of(const std::vector<std::string>& options,
                                   const std::string& scene = "bouncing-balls") {
  const Scratch scratch;
  std::vector<std::string> arguments{"render", scene, "--out", scratch / "film"};
  if (std::ranges::find(options, "--size") == options.end()) arguments.insert(arguments.end(), {"--size", "160x90"});
  if (scene == "bouncing-balls") arguments.insert(arguments.end(), {"--count", "200"});
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run_program(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  std::vector<std::string> frames;
  while (fs::exists(scratch / "film/" + frame(int(frames.size())))) {
    frames.push_back(read_text(scratch / "film/" + frame(int(frames.size()))));
  }
  CHECK(std::distance(fs::directory_iterator(scratch / "film"), {}) == std::ptrdiff_t(frames.size()));
  return frames;
}

/// What a frame shows. Its bytes also say how the film was asked for, in their key.
std::vector<uint8_t> pixels_of(const std::string& bytes) {
  const Scratch scratch;
  write_text(scratch / "frame.png", bytes);
  return read_png(scratch / "frame.png").pixels;
}

}  // namespace

TEST_CASE("twelve frames are twelve PNG files of the size asked for, all different") {
  const Scratch scratch;
  const Outcome outcome =
      run_program({"render", "--out", scratch / "film", "--frames", "12", "--size", "640x360", "--json"});
  REQUIRE(outcome.status == 0);
  CHECK(outcome.json()["rendered"] == 12);
  CHECK(outcome.json()["frames_per_second"].get<double>() > 0);
  CHECK(std::distance(fs::directory_iterator(scratch / "film"), {}) == 12);
  std::vector<std::string> seen;
  for (int k = 0; k < 12; ++k) {
    const Image image = read_png(scratch / "film/" + frame(k));
    CHECK(image.width == 640);
    CHECK(image.height == 360);
    const std::string bytes = read_text(scratch / "film/" + frame(k));
    CHECK(std::find(seen.begin(), seen.end(), bytes) == seen.end());
    seen.push_back(bytes);
  }
}

TEST_CASE("rendering twice gives the same bytes, with any number of threads") {
  const std::vector<std::string> first = frames_of({"--frames", "5", "--threads", "1"});
  CHECK(first.size() == 5);
  CHECK(is_same(frames_of({"--frames", "5", "--threads", "1"}), first));
  CHECK(is_same(frames_of({"--frames", "5", "--threads", "8"}), first));
  CHECK_FALSE(is_same(frames_of({"--frames", "5", "--seed", "2"}), first));
}

TEST_CASE(
    "pictures with occlusion, grid, pairs and paths are the same bytes at every run, with any number of threads") {
  const auto drawn = [](const std::string& threads, const std::string& occlusion) {
    return frames_of({"--frames", "2", "--from", "0.5", "--size", "640x400", "--overlay", "grid,pairs,swept",
                      "--occlusion", occlusion, "--threads", threads},
                     "open-box");  // spheres large enough for occlusion
  };
  const std::vector<std::string> first = drawn("1", "on");
  REQUIRE(first.size() == 2);
  CHECK(is_same(drawn("1", "on"), first));
  CHECK(is_same(drawn("2", "on"), first));
  CHECK_FALSE(is_same(pixels_of(drawn("1", "off")[0]), pixels_of(first[0])));
}

TEST_CASE("the option --copy-bodies changes how spheres reach the picture, and no byte of the frames") {
  CHECK(is_same(frames_of({"--frames", "3", "--copy-bodies"}), frames_of({"--frames", "3"})));
  const Scratch scratch;
  const std::vector<std::string> arguments{"render", "--frames", "1",     "--size",
                                           "64x64",  "--json",   "--out", scratch / "film"};
  CHECK(run_program(arguments).json()["bodies"] == "written by cpu");
  std::vector<std::string> with_copies = arguments;
  with_copies.push_back("--copy-bodies");
  CHECK(run_program(with_copies).json()["bodies"] == "copied");
}

TEST_CASE("frames show the states that --every, --fps and --from ask for") {
  const std::vector<std::string> all = frames_of({"--frames", "9"});
  const std::vector<std::string> every = frames_of({"--frames", "4", "--every", "2"});
  const std::vector<std::string> slower = frames_of({"--frames", "4", "--fps", "30"});
  const std::vector<std::string> later = frames_of({"--frames", "4", "--from", "0.08333333333333333"});
  REQUIRE(all.size() == 9);
  for (size_t k = 0; k < 4; ++k) {
    INFO("frame " << k);
    CHECK(is_same(pixels_of(every[k]), pixels_of(all[2 * k])));
    CHECK(is_same(slower[k], every[k]));
    CHECK(is_same(pixels_of(later[k]), pixels_of(all[k + 5])));
  }
}

TEST_CASE("overlay, theme and supersampling change the picture") {
  const std::string plain = frames_of({"--frames", "1", "--overlay", "none"})[0];
  const std::string grid = frames_of({"--frames", "1"})[0];
  CHECK(is_same(frames_of({"--frames", "1", "--overlay", "grid"})[0], grid));
  CHECK_FALSE(is_same(plain, grid));
  CHECK_FALSE(is_same(frames_of({"--frames", "1", "--theme", "dark"})[0], grid));
  const std::string smooth = frames_of({"--frames", "1", "--supersample", "2"})[0];
  CHECK_FALSE(is_same(smooth, grid));
  const Scratch scratch;
  write_text(scratch / "smooth.png", smooth);
  CHECK(read_png(scratch / "smooth.png").width == 160);
}

TEST_CASE("a planar scene is rendered") {
  const std::vector<std::string> frames = frames_of({"--frames", "2"}, "lecture-grid");
  REQUIRE(frames.size() == 2);
  CHECK_FALSE(is_same(frames[0], frames[1]));
  CHECK_FALSE(is_same(frames_of({"--frames", "1", "--overlay", "none"}, "lecture-grid")[0], frames[0]));
}

TEST_CASE("every built-in scene is rendered") {
  for (const char* scene : {"open-box", "rain", "two-spheres"}) {
    INFO(scene);
    CHECK(frames_of({"--frames", "1"}, scene).size() == 1);
  }
}

TEST_CASE("render reports each overlay that has nothing to draw with a broad phase") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> lacking{
      {"brute-force", {"grid", "lists", "intervals"}},
      {"sort-and-sweep", {"grid", "lists"}},
      {"linked-cell", {"intervals"}},
      {"sorted-grid", {"intervals"}}};
  for (const char* scene : {"lecture-grid", "two-spheres"}) {
    for (const auto& [method, names] : lacking) {
      INFO(scene << ", " << method);
      const Scratch scratch;
      const auto run = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"render",       scene,  "--size", "64x36",
                                           "--frames",     "2",    "--out",  scratch / "film",
                                           "--broadphase", method, "--json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome outcome = run_program(arguments);
        CHECK(outcome.status == 0);
        CHECK(outcome.json()["rendered"] == 2);
        return outcome.err;
      };
      const std::string told = run({"--overlay", "grid,pairs,velocity,swept,labels,lists,intervals,warps"});
      CHECK(std::count(told.begin(), told.end(), '\n') == std::ptrdiff_t(names.size()));
      for (const std::string& name : names)
        CHECK_THAT(told, Catch::Contains("note: --overlay " + name + ": this broad phase "));
      CHECK(run({}).empty());
    }
  }
}

TEST_CASE("a film with the exact ghost can be resumed, and has the same pictures") {
  const auto frames = [](const std::string& folder, const char* count, bool resumes) {
    std::vector<std::string> arguments{"render",  "lecture-grid", "--size",   "320x180", "--overlay", "ghost",
                                       "--every", "60",           "--frames", count,     "--out",     folder};
    if (resumes) arguments.emplace_back("--resume");
    REQUIRE(run_program(arguments).status == 0);
  };
  const Scratch scratch;
  frames(scratch / "whole", "4", false);
  frames(scratch / "parts", "2", false);
  frames(scratch / "parts", "4", true);
  for (int k = 0; k < 4; ++k) {
    const Image whole = read_png(scratch / "whole/" + frame(k)), parts = read_png(scratch / "parts/" + frame(k));
    INFO(k);
    CHECK(whole.pixels == parts.pixels);
  }
}

TEST_CASE("render says where exact motion cannot serve") {
  const Scratch scratch;
  const Outcome outcome = run_program({"render", "stack", "--size", "64x36", "--frames", "1", "--from", "0.2",
                                       "--overlay", "ghost", "--out", scratch / "film"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Catch::Contains("note: --overlay ghost: exact motion ends here"));
}

TEST_CASE("a scene is rendered the same where its lengths are far from a metre") {
  const auto rendered = [](const std::string& exponent) {
    const Scratch scratch;
    const auto length = [&](const char* digits) { return digits + ("e" + exponent); };
    const auto vector = [&](const char* digits) {
      return "[" + length(digits) + ", " + length(digits) + ", " + length(digits) + "]\n";
    };
    write_text(scratch / "s.toml", "[domain]\nmin = [0, 0, 0]\nmax = " + vector("1.0") + "[[spheres]]\nposition = " +
                                       vector("0.5") + "radius = " + length("0.3") + "\nmass = 1\n");
    const Outcome outcome =
        run_program({"render", scratch / "s.toml", "--frames", "1", "--size", "240x135", "--out", scratch / "film"});
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return read_png(scratch / "film/" + frame(0));
  };
  const Image expected = rendered("0");
  for (const char* exponent : {"-10", "-5", "5", "10"}) {
    INFO(exponent);
    const Image actual = rendered(exponent);
    int largest = 0;
    for (size_t k = 0; k < expected.pixels.size(); ++k) {
      largest = std::max(largest, std::abs(int{actual.pixels[k]} - int{expected.pixels[k]}));
    }
    CHECK(largest <= 1);
  }
}

TEST_CASE("compared methods are counted in the summary, and their film is the same at every run") {
  const auto compared = [](const std::string& out) {
    return run_program({"render", "--count", "200", "--compare", "brute-force,linked-cell", "--frames", "2", "--size",
                        "320x180", "--out", out, "--json"})
        .json();
  };
  const Scratch first, second;
  const auto json = compared(first.path().string());
  compared(second.path().string());
  for (int k = 0; k < 2; ++k) CHECK(is_same(read_text(first / frame(k)), read_text(second / frame(k))));
  REQUIRE(json["compare"].size() == 2);
  CHECK(json["compare"][0]["broadphase"] == "brute-force");
  CHECK(json["compare"][0]["tests"] == 19900);
  CHECK(json["compare"][0]["tests_so_far"] == 5 * 19900);  // at the start, and after each of four steps
  CHECK(json["compare"][1]["broadphase"] == "linked-cell");
  CHECK(json["compare"][1]["tests_so_far"] < 19900);
  CHECK(json["compare"][1]["contacts"] == json["compare"][0]["contacts"]);
}

TEST_CASE("a caption and a turn of the camera change the picture, and a turn of nothing changes none") {
  const auto plain = frames_of({"--frames", "2"}), caption = frames_of({"--frames", "2", "--caption", "on"}),
             still = frames_of({"--frames", "2", "--turn", "0"}), turned = frames_of({"--frames", "2", "--turn", "90"});
  CHECK_FALSE(is_same(pixels_of(plain[0]), pixels_of(caption[0])));
  CHECK(is_same(plain, still));
  CHECK_FALSE(is_same(pixels_of(plain[1]), pixels_of(turned[1])));
}
