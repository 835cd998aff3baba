// SPDX-License-Identifier: MIT
// The button that looks for the cheapest settings that are good enough, and what the panel then says.
#include <algorithm>
#include <chrono>

#include <catch2/catch.hpp>

#include "choose/needs_meter.h"
#include "tests/support/desk.h"
#include "tests/support/in_german.h"
#include "tests/support/run_program.h"

using namespace ballpit;

namespace {

const std::string kGas =
    "[domain]\nboundary = \"periodic\"\n[physics]\nrestitution = 1\n"
    "[[fill]]\ncount = 50\nradius = 0.05\nspeed = 1\n[needs]\nduration = 1\n";

/// A desk with a scene of a file.
class DeskOf {
 public:
  explicit DeskOf(const std::string& text) {
    write_text(scratch_ / "a.toml", text), desk_.emplace(scratch_ / "a.toml");
  }
  Desk& operator*() { return *desk_; }

 private:
  Scratch scratch_;
  std::optional<Desk> desk_;
};

/// Presses the button, and waits.
void choose_on(Desk& desk) {
  desk.click("cheapest");
  REQUIRE(desk.demo.is_choosing());
  desk.demo.finish_choosing();
  REQUIRE(desk.demo.choice() != nullptr);
  desk.rest();
}

std::vector<std::string> names_with(Desk& desk, const std::string& start) {
  std::vector<std::string> names;
  for (const auto& [name, rect] : desk.panel.items()) {
    if (name.starts_with(start)) names.push_back(name);
  }
  return names;
}

}  // namespace

TEST_CASE("the button of lecture-grid goes on from the present state with settings that hold what the scene needs") {
  Desk desk;
  for (int k = 0; k < 100; ++k) desk.demo.step();
  const double time = desk.demo.session.time();
  const Bodies before = desk.demo.session.world().bodies();
  choose_on(desk);
  Session& session = desk.demo.session;
  CHECK(session.time() == time);
  CHECK(session.world().bodies().position == before.position);
  REQUIRE(desk.demo.choice()->chosen);
  CHECK(session.settings().response == desk.demo.choice()->chosen->settings.response);
  CHECK(session.settings().dt == desk.demo.choice()->chosen->settings.dt);
  CHECK(session.settings().threads == 1);  // as given
  Scene scene = session.scene();
  scene.bodies = before;
  const Needs needs = effective_needs(scene).needs;
  const NeedsMeter meter(scene, needs, session.world());
  session.advance_to(time + needs.duration, [] { return false; });
  const std::vector<double> errors = meter.errors(session.world(), {});
  const std::vector<Tolerance> tolerances = tolerances_of(needs);
  REQUIRE_FALSE(errors.empty());
  for (size_t k = 0; k < errors.size(); ++k) {
    CAPTURE(tolerances[k].name);
    CHECK(errors[k] <= tolerances[k].allowed);
  }
}

TEST_CASE("the panel says what was chosen, and below it why nothing else was") {
  Desk desk("stack");
  CHECK_FALSE(desk.has("choice"));
  choose_on(desk);
  CHECK(desk.has("choice"));
  CHECK(names_with(desk, "ruled out").empty());
  desk.click("why");
  REQUIRE_FALSE(desk.demo.choice()->ruled_out.empty());
  for (const RuledOut& out : desk.demo.choice()->ruled_out) {
    const auto lines = names_with(desk, "ruled out ");
    CAPTURE(out.method);
    CHECK(std::ranges::any_of(lines, [&](const std::string& line) { return line.find(out.method) != line.npos; }));
  }
  CHECK(desk.has("not needed"));
  CHECK_FALSE(names_with(desk, "tried ").empty());
  CHECK_FALSE(desk.has("nearest"));
}

TEST_CASE("the scene plays on while settings are chosen, and pictures are drawn") {
  Desk desk("gas-dense");
  desk.demo.player.is_running = true;
  const auto start = std::chrono::steady_clock::now();
  desk.demo.choose_cheapest();
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 0.2);
  desk.demo.advance(0.05, 0.05);
  desk.frame(PanelInput{});
  REQUIRE(desk.demo.is_choosing());  // of some 2 s
  CHECK(desk.demo.session.world().steps() > 0);
  const int64_t worlds = desk.demo.worlds();
  while (desk.demo.is_choosing()) {
    desk.demo.advance(0.01, 0.01);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  CHECK(desk.demo.worlds() == worlds + 1);  // advance() has taken the choice
  CHECK(desk.demo.choice() != nullptr);
}

TEST_CASE("a second press, another setting or another scene gives up the choice, and its settings are not taken") {
  Desk desk("gas-dense");
  desk.click("cheapest");
  REQUIRE(desk.demo.is_choosing());
  std::string scene = "gas-dense";
  SECTION("a second press") { desk.click("cheapest"); }
  SECTION("another setting") { desk.demo.set("substeps", "2"); }
  SECTION("other physics") {
    Physics physics = desk.demo.session.scene().physics;
    physics.restitution = 0.5;
    desk.demo.set_physics(physics);
  }
  SECTION("another scene") { desk.demo.load(scene = "stack"); }
  CHECK_FALSE(desk.demo.is_choosing());
  const Response response = desk.demo.session.settings().response;
  desk.demo.finish_choosing();
  desk.demo.advance(0.01, 0.01);
  CHECK(desk.demo.session.scene_name() == scene);
  CHECK(desk.demo.session.settings().response == response);
  CHECK(desk.demo.choice() == nullptr);
}

TEST_CASE("another scene, or other physics, has nothing of the choice before") {
  Desk desk;
  choose_on(desk);
  CHECK(desk.has("prediction"));
  SECTION("another scene") { desk.demo.load("two-spheres"); }
  SECTION("other physics") {
    Physics physics = desk.demo.session.scene().physics;
    physics.stiffness *= 2;
    desk.demo.set_physics(physics);
  }
  desk.rest();
  CHECK_FALSE(desk.has("choice"));
  CHECK_FALSE(desk.has("prediction"));
}

TEST_CASE("where nothing holds, the settings stay, and the panel says what came nearest") {
  DeskOf held(kGas + "max_speed = 0.001\n");  // of a gas that keeps its energy
  Desk& desk = *held;
  const int64_t worlds = desk.demo.worlds();
  choose_on(desk);
  CHECK_FALSE(desk.demo.choice()->chosen);
  CHECK(desk.demo.worlds() == worlds);
  CHECK(desk.has("choice"));
  CHECK_FALSE(desk.has("prediction"));
  desk.has("why");
  desk.click("why");
  CHECK(desk.has("nearest"));
}

TEST_CASE("where every method is ruled out, the settings stay, too") {
  DeskOf held(kGas + "effects = [\"contact-time\", \"momentum-order\"]\n");
  Desk& desk = *held;
  const int64_t worlds = desk.demo.worlds();
  choose_on(desk);
  CHECK(desk.demo.worlds() == worlds);
  CHECK(desk.has("choice"));
}

TEST_CASE("a choice that cannot be made is a message, and the demonstration goes on") {
  DeskOf held(kGas + "[needs.observables]\nno-such-thing = 0.1\n");
  Desk& desk = *held;
  desk.click("cheapest");
  desk.demo.finish_choosing();
  CHECK_THAT(desk.demo.message(), Catch::Contains("no-such-thing"));
  CHECK(desk.demo.choice() == nullptr);
}

TEST_CASE("neither moved sliders nor the choice before bind the choice") {
  Desk desk;
  desk.demo.set("response", "penalty");
  desk.demo.set("dt", "0.03");
  for (int k = 0; k < 2; ++k) {
    choose_on(desk);
    REQUIRE(desk.demo.choice()->chosen);
    CHECK(desk.demo.session.settings().dt != 0.03);
    CHECK(desk.demo.choice()->tried.size() > 2);  // more than one method
    CHECK(desk.demo.session.settings().threads == 1);
  }
}

TEST_CASE("the chart shows what the choice expects, and play comes near it") {
  Desk desk("stack");
  choose_on(desk);
  REQUIRE(desk.has("prediction"));
  REQUIRE(desk.demo.trade_off.prediction);
  const Played expected = *desk.demo.trade_off.prediction;
  for (int k = 0; k < 2000; ++k) {
    desk.demo.step();
    desk.demo.report();
  }
  const Played& played = desk.demo.trade_off.trials()[size_t(desk.demo.trade_off.current())];
  CHECK(played.overlap > 0);
  CHECK(expected.overlap > 0.5 * played.overlap);  // the pilot looks now and then
  CHECK(expected.overlap < 1.1 * played.overlap);
  CHECK(expected.cost() < 10 * played.cost());
  CHECK(played.cost() < 10 * expected.cost());
  desk.demo.set("response", "penalty");
  desk.click("prediction");  // returns to it, as to a trial
  CHECK(desk.demo.session.settings().response == desk.demo.choice()->chosen->settings.response);
}

TEST_CASE("the list of responses has none that takes seconds") {
  Desk desk;
  desk.click("response");
  CHECK(desk.has("response penalty"));
  CHECK_FALSE(desk.has("response auto"));
}

TEST_CASE("no line about the choice is cut off, at any scale, in both languages") {
  std::optional<InGerman> in_german;
  if (GENERATE(false, true)) in_german.emplace();
  for (const float scale : {0.5f, 1.0f, 2.0f, 3.0f}) {
    Desk desk("stack");
    desk.demo.view.ui_scale = scale;
    choose_on(desk);
    desk.click("why");
    const auto right = float(Panel::width_in(Desk::kWidth, Desk::kHeight, scale));
    CHECK(names_with(desk, "tried ").size() > 0);
    for (const auto& [name, rect] : desk.panel.items()) {
      CAPTURE(scale, name);
      if (!name.starts_with("tab ")) CHECK(rect.high.x <= right);
    }
  }
}

TEST_CASE("render waits for the choice of a click on the button") {
  const Scratch scratch;
  const Outcome run = run_program({"render", "lecture-grid", "--panel", "--click", "cheapest,why,ruled out kinematic",
                                   "--frames", "1", "--out", scratch / "film"});
  CAPTURE(run.err);
  CHECK(run.status == 0);
}
