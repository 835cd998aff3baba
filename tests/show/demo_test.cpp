// SPDX-License-Identifier: MIT
// A demonstration as it is operated, without a window.
#include "show/demo.h"

#include <filesystem>
#include <fstream>
#include <set>

#include <catch2/catch.hpp>

#include "core/numbers.h"
#include "render/overlays/overlay.h"
#include "render/painter.h"
#include "tests/show/key_named.h"
#include "tests/support/in_german.h"

using namespace ballpit;

namespace {

Demo lecture() { return Demo("lecture-grid", {{"threads", "1"}}); }

}  // namespace

TEST_CASE("the keys 1 to 4 switch the method, and the state goes on where it was") {
  Demo demo = lecture();
  for (int k = 0; k < 20; ++k) demo.step();
  const uint64_t state = demo.report().state_hash;
  const double time = demo.session.time();
  for (const auto& [key, method] : {std::pair{"1", "brute-force"}, {"2", "sort-and-sweep"}, {"4", "sorted-grid"}}) {
    demo.perform(key_named(key));
    CHECK(demo.report().broadphase == method);
    CHECK(demo.report().state_hash == state);
    CHECK(demo.session.time() == Approx(time));
  }
}

TEST_CASE("one step back and one forward give the same bits") {
  Demo demo = lecture();
  for (int k = 0; k < 20; ++k) demo.step();
  const uint64_t state = demo.report().state_hash;
  demo.perform(key_named(","));
  CHECK(demo.timeline->step_now() == 19);
  CHECK(demo.report().state_hash != state);
  demo.perform(key_named("."));
  CHECK(demo.report().state_hash == state);
  demo.go_to(3);
  demo.go_to(20);
  CHECK(demo.report().state_hash == state);
}

TEST_CASE("the timeline reaches over a change of method") {
  Demo demo = lecture();
  std::vector<uint64_t> states;
  const auto play = [&](int steps) {
    for (int k = 0; k < steps; ++k) {
      states.push_back(demo.report().state_hash);
      demo.step();
    }
  };
  play(20);
  demo.perform(key_named("1"));
  play(20);
  demo.set("skin", "0.2");
  play(20);
  for (const int step : {5, 50, 20, 39, 0}) {
    demo.go_to(step);
    CHECK(demo.report().state_hash == states[static_cast<size_t>(step)]);
    CHECK(demo.report().broadphase == "brute-force");
  }
}

TEST_CASE("cells that miss contacts begin a timeline of their own") {
  Demo demo = lecture();
  for (int k = 0; k < 5; ++k) demo.step();
  demo.set("cell-size", "0.5");
  CHECK(demo.timeline->first() == 5);
  demo.step();
  demo.set("cell-size", "1");
  CHECK(demo.timeline->first() == 6);
}

TEST_CASE("a mistake becomes a message, and changes nothing") {
  Demo demo = lecture();
  demo.step();
  const uint64_t state = demo.report().state_hash;
  demo.set("dt", "much");
  CHECK_THAT(demo.message(), Catch::Contains("--dt: found much, allowed 1e-12 to 10"));
  CHECK(demo.report().state_hash == state);
  demo.load("no-such-scene");
  CHECK_THAT(demo.message(), Catch::Contains("no-such-scene"));
  CHECK(demo.session.scene().name == "lecture-grid");
  demo.set("dt", "0.001");
  CHECK(demo.message().empty());
  CHECK(demo.session.settings().dt == 0.001);
}

TEST_CASE("options that do not go with another response are dropped, not refused") {
  Demo demo = lecture();
  demo.set("iterations", "8");
  demo.set("response", "penalty");
  CHECK(demo.message().empty());
  CHECK(demo.session.settings().response == Response::penalty);
  CHECK_FALSE(demo.session.settings().iterations.has_value());
}

TEST_CASE("restarting gives the scene's start, by the bits of the first time") {
  Demo demo = lecture();
  const uint64_t start = demo.report().state_hash;
  demo.step();
  CHECK(demo.report().state_hash != start);
  demo.perform(key_named("R"));
  CHECK(demo.report().state_hash == start);
  CHECK(demo.session.time() == 0);
}

TEST_CASE("the player makes the steps that the clock asks for, and gives up what it cannot make") {
  Demo demo = lecture();
  const double dt = demo.session.settings().dt;
  demo.advance(10.5 * dt, 100);
  CHECK(demo.timeline->step_now() == 10);
  demo.advance(0.6 * dt, 100);
  CHECK(demo.timeline->step_now() == 11);
  demo.advance(1e6 * dt, 0);  // no time for it: one step, and nothing is owed afterwards
  CHECK(demo.timeline->step_now() == 12);
  demo.advance(0.5 * dt, 100);
  CHECK(demo.timeline->step_now() == 12);
  demo.perform(key_named("Space"));
  demo.advance(100 * dt, 100);
  CHECK(demo.timeline->step_now() == 12);
}

TEST_CASE("a run that cannot go on is paused, and says why until the scene restarts") {
  Demo demo("cradle", {{"dt", "0.01"}, {"threads", "1"}, {"max-energy", "1.5"}, {"integrator", "explicit-euler"}});
  demo.advance(100, 100);
  CHECK_FALSE(demo.player.is_running);
  CHECK_THAT(demo.player.failure(), Catch::Contains("step "));
  demo.restart();
  CHECK(demo.player.failure().empty());
}

TEST_CASE("what is shown is looked at with what the overlays ask for") {
  Demo demo = lecture();
  CHECK(demo.inspection().candidates.empty());
  demo.perform(key_named("P"));
  CHECK_FALSE(demo.inspection().candidates.empty());
  demo.perform(key_named("2"));
  demo.perform(key_named("I"));
  CHECK(demo.inspection().endpoints.size() == 40);
}

TEST_CASE("what would take too long to look for is left out, and the picture knows") {
  Demo demo("rain", {{"count", "21000"}, {"broadphase", "brute-force"}, {"threads", "1"}});
  demo.perform(key_named("P"));
  const FrameView view = demo.frame_view(1);
  CHECK(view.left_out.missed);
  CHECK(view.left_out.candidates);
  CHECK(view.inspection.candidates.empty());
  CHECK_FALSE(lecture().frame_view(1).left_out.more_than_state());
}

TEST_CASE("each key is one key, and names a method or an overlay that there is") {
  Demo demo = lecture();
  std::set<int> codes;
  for (const Key& key : key_table()) {
    CAPTURE(key.name);
    CHECK(codes.insert(key.code).second);
    demo.perform(key);
    CHECK(demo.message().empty());
    for (const std::string& overlay : demo.view.overlays) CHECK_NOTHROW(entry_named(overlay_table(), overlay, "key"));
  }
}

TEST_CASE("the README names each key of a demonstration") {
  std::ifstream in(BALLPIT_GOLDEN_FOLDER "/../../README.md");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  for (const Key& key : key_table()) {
    std::string quoted(key.name);
    quoted.insert(0, 1, '`').push_back('`');
    CHECK_THAT(text, Catch::Contains(quoted));
  }
}

TEST_CASE("a scene of a file restarts from that file") {
  const std::string path = BALLPIT_GOLDEN_FOLDER "/../../assets/scenes/lecture-sweep.toml";
  Demo demo(path, {{"threads", "1"}});
  const uint64_t start = demo.report().state_hash;
  demo.step();
  CHECK(demo.report().state_hash != start);
  std::filesystem::copy_file(path, "restarted.toml", std::filesystem::copy_options::overwrite_existing);
  Demo own("./restarted.toml", {{"threads", "1"}});
  own.step();
  own.perform(key_named("R"));
  CHECK(own.message().empty());
  CHECK(own.report().state_hash == start);
  std::filesystem::remove("restarted.toml");
}

TEST_CASE("numbers are written for the audience") {
  CHECK(grouped(1234567) == "1\u2009234\u2009567");
  CHECK(grouped(-123) == "-123");
  CHECK(grouped(0) == "0");
  CHECK(three_digits(12.345) == "12.3");
  CHECK(three_digits(0.0012) == "1.20e-03");
  CHECK(three_digits(1234) == "1234");
  CHECK(three_digits(0) == "0.000");
}

TEST_CASE("a caption names the scene and counts its tests, in the language set, above and below the scene") {
  Demo demo("lecture-contacts", {{"threads", "1"}});
  CHECK(demo.frame_view(1.5f).page == nullptr);
  demo.view.has_caption = true;
  demo.step();
  const FrameView view = demo.frame_view(1.5f);
  REQUIRE(view.page);
  CHECK(view.page->title == demo.session.scene().title);
  const std::string tests = std::to_string(demo.report().candidates);
  CHECK_THAT(view.page->caption, Catch::StartsWith("20 spheres: " + tests + " tests in place of 190, "));
  CHECK_FALSE(view.page->is_still);
  demo.set("response", "event-driven");
  demo.step();
  CHECK_THAT(demo.frame_view(1.5f).page->caption, Catch::Contains(" collision") && Catch::EndsWith(" so far"));
  demo.set("response", "impulse");
  demo.step();
  const InGerman in_german;
  const FrameView german = demo.frame_view(1.5f);
  CHECK(german.page->title == demo.session.scene().title_de);
  CHECK_THAT(german.page->caption, Catch::StartsWith("20 Kugeln: " + tests + " Tests statt 190, "));
}
