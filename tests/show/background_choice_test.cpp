// SPDX-License-Identifier: MIT
#include "show/background_choice.h"

#include <chrono>
#include <memory>
#include <thread>

#include <catch2/catch.hpp>

#include "scene/read_scene.h"

using namespace ballpit;

namespace {

Scene gas(const std::string& needs) {
  return parse_scene(
      "[domain]\nboundary = \"periodic\"\n[physics]\nrestitution = 1\n[[fill]]\ncount = 400\nradius = 0.02\nspeed = "
      "1\n" +
          needs,
      "a.toml");
}

/// No method holds it, so that the search uses its whole budget.
Scene demanding_gas() {
  return gas("[needs]\nduration = 100\nenergy_tolerance = 1e-15\neffects = [\"contact-time\"]\n");
}

double seconds_of(const auto& action) {
  const auto start = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("a choice in the background is that of choose(), and is given once") {
  BackgroundChoice background;
  CHECK_FALSE(background.wait());
  background.begin(gas("[needs]\nduration = 1\nmax_overlap = 0.1\n"), {{"threads", "1"}}, 2);
  CHECK(background.is_running());
  const auto result = background.wait();
  REQUIRE(result);
  REQUIRE(result->choice);
  CHECK(result->choice->chosen);
  CHECK(result->choice->chosen->settings.threads == 1);
  CHECK_FALSE(background.is_running());
  CHECK_FALSE(background.result());
}

TEST_CASE("an abandoned choice gives no result, and ends long before its budget") {
  auto background = std::make_unique<BackgroundChoice>();
  CHECK(seconds_of([&] { background->begin(demanding_gas(), {}, 60); }) < 0.5);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  CHECK_FALSE(background->result());
  CHECK(seconds_of([&] { background->abandon(); }) < 0.1);  // does not wait
  CHECK_FALSE(background->is_running());
  CHECK_FALSE(background->wait());
  CHECK(seconds_of([&] { background.reset(); }) < 10);  // waits
}

TEST_CASE("a second choice takes the place of the first one") {
  BackgroundChoice background;
  background.begin(demanding_gas(), {}, 60);
  background.begin(gas("[needs]\nduration = 1\nmax_overlap = 0.1\n"), {}, 2);
  const auto result = background.wait();
  REQUIRE(result);
  REQUIRE(result->choice);
  CHECK(result->choice->needs.needs.duration == 1);
}

TEST_CASE("a choice that cannot be made says why") {
  BackgroundChoice background;
  background.begin(gas("[needs]\nduration = 1\n[needs.observables]\nno-such-thing = 0.1\n"), {}, 2);
  const auto result = background.wait();
  REQUIRE(result);
  CHECK_FALSE(result->choice);
  CHECK_THAT(result->failure, Catch::Contains("no-such-thing"));
}
