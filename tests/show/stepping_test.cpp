// SPDX-License-Identifier: MIT
#include "show/stepping.h"

#include <catch2/catch.hpp>

using namespace ballpit;

namespace {

Demo demo_of(const char* scene, const char* method) { return Demo(scene, {{"threads", "1"}, {"broadphase", method}}); }

}  // namespace

TEST_CASE("stepping to the end of a kernel finds the contacts of the moment, by each method of the slides") {
  for (const char* method : {"brute-force", "sort-and-sweep", "linked-cell", "lecture/linked-cell"}) {
    Demo demo = demo_of("lecture-contacts", method);
    Stepping stepping(demo);
    CHECK_FALSE(stepping.cursor());
    stepping.move(1);
    REQUIRE(stepping.cursor());
    CHECK(stepping.cursor()->at() == 1);
    CHECK_FALSE(stepping.frame_view(1.5f).page->code.empty());
    stepping.move(1'000'000);
    CHECK(stepping.cursor()->at() == stepping.cursor()->last());
    const FrameView view = stepping.frame_view(1.5f);
    CHECK(view.inspection.contacts == demo.inspection().contacts);
    CHECK(view.inspection.contacts.size() == 4);
    CHECK(view.inspection.missed.empty());
    CHECK_THAT(view.page->caption, Catch::EndsWith(", 4 contacts"));
  }
}

TEST_CASE("stepping ends when the scene moves on or the method changes") {
  Demo demo = demo_of("lecture-contacts", "linked-cell");
  Stepping stepping(demo);
  const auto begin = [&] {
    stepping.skip_phase(1);
    REQUIRE(stepping.cursor());
    CHECK(stepping.cursor()->at() == stepping.cursor()->run().phases.front().last);
  };
  begin();
  demo.step();
  CHECK_FALSE(stepping.cursor());
  begin();
  demo.set("broadphase", "sort-and-sweep");
  CHECK_FALSE(stepping.cursor());
  begin();
  demo.load("lecture-grid");
  CHECK_FALSE(stepping.cursor());
  stepping.move(1);
  stepping.end();
  CHECK_FALSE(stepping.cursor());
}

TEST_CASE("where there is no kernel to step through, a line says why") {
  Demo demo = demo_of("lecture-contacts", "sorted-grid");
  Stepping stepping(demo);
  stepping.move(1);
  CHECK_FALSE(stepping.cursor());
  CHECK_THAT(demo.message(), Catch::Contains("no kernel of sorted-grid"));
  Demo crowd = demo_of("bouncing-balls", "linked-cell");
  Stepping in_crowd(crowd);
  in_crowd.move(1);
  CHECK_FALSE(in_crowd.cursor());
  CHECK_THAT(crowd.message(), Catch::Contains("500"));
}

TEST_CASE("stepping shows the arrays of the kernel, and leaves the view as it was") {
  Demo demo = demo_of("lecture-contacts", "linked-cell");
  demo.view.overlays = {"velocity"};
  Stepping stepping(demo);
  stepping.move(1);
  const FrameView frame = stepping.frame_view(1.5f);
  for (const char* overlay : {"grid", "labels", "lists", "pairs", "velocity"}) CHECK(frame.shows(overlay));
  CHECK(frame.page->title == "linked-cell: clear");
  CHECK(demo.view.overlays == std::vector<std::string>{"velocity"});
}
