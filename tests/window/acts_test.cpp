// SPDX-License-Identifier: MIT
// Acts that the window saves: the same run, film and state again, without a window.
#include <filesystem>

#include <catch2/catch.hpp>

#include "export/png.h"
#include "render/gl_context.h"
#include "show/hand.h"
#include "tests/support/desk.h"
#include "tests/support/run_program.h"
#include "window/saver.h"
#include "window/show_window.h"

using namespace ballpit;
namespace fs = std::filesystem;

namespace {

/// A demonstration that was acted on by hand: a throw at the start, a push, a drop, and another throw.
struct Acted {
  const Scratch scratch;
  const Within within{scratch.path()};
  const GlContext context;
  Demo demo{"lecture-grid", {{"threads", "1"}, {"broadphase", "sort-and-sweep"}}};
  Hand hand{demo};
  Saver saver{demo};

  void drag(size_t i, const Vec3d& way, ActKind kind) {
    const FrameView view = demo.frame_view(16.0f / 9);
    const auto place_of = [&](const Vec3d& p) {
      const Vec4 clip = view.camera.projection() * view.camera.view() * Vec4(Vec3(p), 1);
      return Vec2(clip) / clip.w;
    };
    const Vec3d at = demo.session.world().bodies().position[i];
    REQUIRE(hand.grab(view, place_of(at), kind));
    hand.drag(view, place_of(at + way));
    hand.release();
  }
  void play(int steps) {
    for (int k = 0; k < steps; ++k) demo.step();
  }
  void perform() {
    drag(3, {0.4, 0.7, 0}, ActKind::to_throw);
    play(11);
    drag(12, {-0.3, 0.2, 0}, ActKind::push);
    play(9);
    const FrameView view = demo.frame_view(16.0f / 9);
    const Vec4 clip = view.camera.projection() * view.camera.view() * Vec4(1.7f, 4.35f, 0, 1);
    hand.drop(view, Vec2(clip));
    INFO(demo.message());
    REQUIRE(demo.session.world().shape().count == 21);
    play(4);
    drag(20, {0.1, -0.9, 0}, ActKind::to_throw);
    play(16);
  }
};

}  // namespace

TEST_CASE_METHOD(Acted, "saved acts give the same state without a window, on any threads and broad phase") {
  perform();
  saver.save_acts();
  CHECK(demo.message() == "saved acts_00000.toml");
  CHECK_THAT(read_text("acts_00000.toml"),
             Catch::Contains("#   ballpit show lecture-grid --threads 1 --broadphase sort-and-sweep --acts "
                             "acts_00000.toml\n\n[[act]]\ntime = 0\n"));
  const std::string hash = fmt::format("{:016x}", demo.report().state_hash);
  const std::string time = fmt::format("{}", demo.session.time());
  for (const std::vector<std::string>& way :
       {std::vector<std::string>{"--threads", "2"}, {"--broadphase", "sorted-grid", "--skin", "0.2"}}) {
    std::vector<std::string> arguments{
        "simulate", "lecture-grid", "--time", time, "--json", "--acts", scratch / "acts_00000.toml"};
    arguments.insert(arguments.end(), way.begin(), way.end());
    const Outcome outcome = run_program(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.json()["state_hash"] == hash);
    CHECK(outcome.json()["count"] == 21);
    CHECK(outcome.json()["steps"] == 40);
  }
}

TEST_CASE_METHOD(Acted, "a film of a run that was acted on has the frames that render makes of its acts, to the byte") {
  perform();
  demo.set("broadphase", "linked-cell");
  demo.go_to(0);
  saver.start_film({320, 180}, 11);
  for (int turns = 0; saver.is_filming() && turns < 30; ++turns) saver.advance();
  CHECK(demo.message() == "11 frames in frames_00000");
  CHECK(demo.session.acts().all().size() == 4);
  const auto made = [&](const std::string& folder, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render",   "lecture-grid", "--out",  scratch / folder,
                                       "--frames", "11",           "--size", "320x180"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    REQUIRE(run_program(arguments).status == 0);
    return folder;
  };
  const std::string again = made("again", {"--acts", scratch / "frames_00000/acts.toml"}), plain = made("plain", {});
  for (const char* name : {"frame_00000.png", "frame_00003.png", "frame_00006.png", "frame_00010.png"}) {
    const std::string frame = read_text(fs::path("frames_00000") / name);
    const bool is_same = frame == read_text(fs::path(again) / name),
               is_plain = frame == read_text(fs::path(plain) / name);
    CHECK(is_same);
    CHECK_FALSE(is_plain);
  }
}

TEST_CASE_METHOD(Acted,
                 "a change of physics in between is named in the file, a film without acts has no file of them") {
  saver.start_film({64, 36}, 1);
  saver.advance();
  CHECK(fs::exists("frames_00000/frame_00000.png"));
  CHECK_FALSE(fs::exists("frames_00000/acts.toml"));
  play(6);
  Physics physics = demo.session.scene().physics;
  physics.restitution = 0.5;
  demo.set_physics(physics);
  drag(3, {0.4, 0.7, 0}, ActKind::to_throw);
  saver.save_acts();
  CHECK_THAT(read_text("acts_00000.toml"), Catch::Contains("# But settings or physics were changed at t = 0.025 s"));
}

TEST_CASE("the panel saves acts once there are any, and F1 lists what the hand can do") {
  Desk desk;
  CHECK_FALSE(desk.has("save acts"));  // in a lecture
  for (const std::string_view gesture : hand_gestures()) desk.panel.gestures.emplace_back(gesture);
  CHECK_FALSE(desk.is_enabled("save acts"));
  desk.demo.act({.sphere = 0, .vector = {1, 0, 0}});
  REQUIRE(desk.is_enabled("save acts"));
  desk.click("save acts");
  CHECK(desk.panel.requests.acts);
}

TEST_CASE("what the hand aims at is ringed, with an arrow of its colour") {
  Desk desk;
  const auto picture = [&] {
    desk.rest();
    return desk.renderer.read_pixels();
  };
  const Image before = picture();
  Hand hand(desk.demo);
  const FrameView view = desk.demo.frame_view(1.2f);
  const BodySnapshot& bodies = view.inspection.bodies;
  const Vec4 clip = view.camera.projection() * view.camera.view() * Vec4(bodies.position_of(11), 1);
  REQUIRE(hand.grab(view, Vec2(clip), ActKind::push));
  hand.drag(view, Vec2(clip) + Vec2(0.2f, 0.2f));
  const Image aimed = picture();
  hand.cancel();
  const Image after = picture();
  size_t purple = 0;
  for (size_t k = 0; k < aimed.pixels.size(); k += 4) {
    const auto is = [&](int c, int value) { return std::abs(int(aimed.pixels[k + size_t(c)]) - value) < 12; };
    purple += is(0, 0xCC) && is(1, 0x79) && is(2, 0xA7);
  }
  CHECK(purple > 300);
  CHECK(after.pixels == before.pixels);
}
