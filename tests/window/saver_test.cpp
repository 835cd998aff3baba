// SPDX-License-Identifier: MIT
// Pictures, states and films that are saved while a demonstration is operated.
#include "window/saver.h"

#include <filesystem>

#include <catch2/catch.hpp>

#include "render/gl_context.h"
#include "tests/support/picture_compare.h"
#include "tests/support/run_program.h"

using namespace ballpit;
namespace fs = std::filesystem;

namespace {

/// A demonstration that saves into a folder of its own.
struct Operated {
  const Scratch scratch;
  const Within within{scratch.path()};
  const GlContext context;
  Demo demo{"lecture-grid", {{"threads", "1"}}};
  Saver saver{demo};
};

}  // namespace

TEST_CASE_METHOD(Operated, "pictures and states get the first free name, and a message says so") {
  saver.save_picture({160, 90});
  CHECK(demo.message() == "saved picture_00000.png");
  saver.save_picture({160, 90});
  CHECK(demo.message() == "saved picture_00001.png");
  CHECK(read_png("picture_00001.png").width == 160);
  saver.save_state();
  CHECK(demo.message() == "saved state_00000.csv");
  demo.step();
  saver.save_state();
  CHECK(read_text("state_00000.csv") != read_text("state_00001.csv"));
  const Outcome again = run_program({"pairs", scratch / "state_00001.csv", "--json"});
  CHECK(again.json()["count"] == 20);
}

TEST_CASE_METHOD(Operated, "an exported film has the frames that render makes") {
  saver.start_film({320, 180}, 4);
  CHECK_FALSE(demo.player.is_running);
  int turns = 0;
  for (; saver.is_filming() && turns < 10; ++turns) saver.advance();
  CHECK(turns == 4);
  CHECK(demo.message() == "4 frames in frames_00000");
  CHECK(demo.timeline->first() == 0);
  CHECK(demo.timeline->furthest() == 12);  // three sixtieths in steps of 1/240 s: the way can be gone back
  REQUIRE(
      run_program({"render", "lecture-grid", "--out", scratch / "made", "--frames", "4", "--size", "320x180"}).status ==
      0);
  for (const char* name : {"frame_00000.png", "frame_00003.png"}) {
    const bool is_same = read_text(fs::path("frames_00000") / name) == read_text(fs::path("made") / name);
    CHECK(is_same);
  }
  CHECK_FALSE(fs::exists("frames_00000/frame_00004.png"));
}

TEST_CASE_METHOD(Operated, "a film ends with the world that it shows") {
  for (int k = 0; k < 100; ++k) demo.step();
  saver.start_film({160, 90}, 100);
  saver.advance();
  demo.set("broadphase", "sort-and-sweep");  // the same world
  CHECK(saver.is_filming());
  demo.set("response", "kinematic");
  saver.advance();
  CHECK_FALSE(saver.is_filming());
  CHECK(demo.message() == "1 frame in frames_00000");
  CHECK(demo.session.world().steps() == 0);
}

TEST_CASE_METHOD(Operated, "a film ends where the world is stepped beyond its next frame") {
  saver.start_film({160, 90}, 100);
  saver.advance();
  for (int k = 0; k < 60; ++k) demo.step();
  saver.advance();
  CHECK_FALSE(saver.is_filming());
  CHECK(demo.message() == "1 frame in frames_00000");
}

TEST_CASE_METHOD(Operated, "a film that is stopped keeps its frames, one that cannot be drawn says why") {
  saver.start_film({160, 90}, 100);
  saver.advance();
  saver.advance();
  saver.stop_film();
  CHECK_FALSE(saver.is_filming());
  CHECK(demo.message() == "2 frames in frames_00000");
  CHECK(fs::exists("frames_00000/frame_00001.png"));
  saver.start_film({1 << 20, 90}, 5);
  CHECK_FALSE(saver.is_filming());
  CHECK_THAT(demo.message(), Catch::Contains("--size: found 1048576x90"));
}
