// SPDX-License-Identifier: MIT
// --response auto: a run that gets harder goes back and on with dearer settings, and gives in the end what its scene
// needs.
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "choose/needs_meter.h"
#include "core/error.h"
#include "core/file.h"
#include "scene/read_scene.h"
#include "show/session.h"

using namespace ballpit;

namespace {

/// Spheres that fall one after another onto a growing stack, in a corner that pilots do not see: thousands of others
/// lie on the floor, and pilots are made of a part of them.
std::string growing_stack() {
  constexpr int kSide = 50, kStack = 16;
  constexpr double kRadius = 0.05, kPitch = 0.12;
  std::string text =
      "[domain]\nmax = [6.3, 8, 6.3]\n[physics]\ngravity = [0, -9.81, 0]\nrestitution = 0\n"
      "[needs]\nduration = 2.5\nmax_overlap = 0.02\nmax_speed = 0.5\n";
  const auto sphere = [&](double x, double y, double z) {
    text += fmt::format("[[spheres]]\nposition = [{}, {}, {}]\nradius = {}\n", x, y, z, kRadius);
  };
  for (int k = 0; k < kSide * kSide; ++k) {
    sphere(0.06 + kPitch * (k % kSide), kRadius, 0.06 + kPitch * (k / kSide));
  }
  for (int k = 0; k < kStack; ++k) sphere(6.2, kRadius + k * 0.15, 6.2);
  return text;
}

const std::filesystem::path kScene = std::filesystem::temp_directory_path() / "ballpit-growing-stack.toml";
const std::filesystem::path kRecord = std::filesystem::temp_directory_path() / "ballpit-growing-stack.json";
const std::vector<GivenOption> kAuto{{"response", "auto"}};

bool never() { return false; }

/// The errors at the end, by tolerance.
std::vector<double> run_to_end(Session& session, const Scene& scene, World& start) {
  const NeedsMeter meter(scene, session.choice()->needs.needs, start);
  session.advance_to(scene.needs.duration, never);
  return meter.errors(session.world(), {});
}

}  // namespace

TEST_CASE("a growing stack makes a run step up, and it meets the needs in the end", "[slow]") {
  write_file(kScene, growing_stack());
  const Scene scene = read_scene(kScene);
  Session session(kScene.string(), kAuto);
  REQUIRE(session.choice() != nullptr);
  REQUIRE(session.choice()->chosen);
  CHECK(session.choice()->pilot_spheres < scene.bodies.size());
  CHECK(session.settings().response != Response::automatic);
  const auto start = cpu_backend().make_world(scene, session.settings());
  write_file(kRecord, json_of(*session.choice(), kScene.string(), scene, kAuto).dump());
  const std::vector<double> errors = run_to_end(session, scene, *start);
  INFO(session.choice()->reason);
  CHECK(session.steps_up().size() >= 1);
  for (const Session::StepUp& up : session.steps_up()) {
    CHECK(up.time < 2.5);
    CHECK_THAT(up.reason, Catch::Contains("overlap") || Catch::Contains("left the domain"));
  }
  CHECK(session.time() == Approx(2.5).margin(session.settings().dt));
  CHECK(session.report().steps > session.world().steps());  // those before the last change count, too
  REQUIRE(errors.size() == 2);
  CHECK(errors[0] <= 0.02);
  CHECK(errors[1] <= 0.5);

  // What is written down gives the same bits, although times are measured.
  Session again(kScene.string(), kAuto, false, kRecord);
  again.advance_to(2.5, never);
  CHECK(again.report().state_hash == session.report().state_hash);
  CHECK(again.steps_up().size() == session.steps_up().size());

  // Without dearer settings the run ends with an error, not with a result that breaks the needs.
  nlohmann::ordered_json record = nlohmann::ordered_json::parse(read_file(kRecord));
  record["dearer"] = nlohmann::ordered_json::array();
  write_file(kRecord, record.dump());
  Session poor(kScene.string(), kAuto, false, kRecord);
  CHECK_THROWS_WITH(poor.advance_to(2.5, never), Catch::Contains("no dearer settings are left"));
  std::filesystem::remove(kScene);
  std::filesystem::remove(kRecord);
}

TEST_CASE("built-in scenes that come to rest, cool, or move forever give what they need with auto", "[slow]") {
  for (const char* const name : {"dense-bed", "open-box", "stack", "mass-ratio", "cooling-gas", "cradle", "bullet"}) {
    Session session(name, kAuto);
    const Scene scene = load_scene(name);
    const auto start = cpu_backend().make_world(scene, session.settings());
    const std::vector<double> errors = run_to_end(session, scene, *start);
    const std::vector<Tolerance> tolerances = tolerances_of(scene.needs);
    for (size_t k = 0; k < errors.size(); ++k) {
      const std::optional<Attempt>& chosen = session.choice()->chosen;
      INFO(name << ", " << tolerances[k].name << ": " << session.choice()->reason);
      REQUIRE(chosen);
      if (chosen->is_unseen[k]) continue;  // of a machine so slow that no pilot reached the end, as the reason says
      CHECK(errors[k] <= tolerances[k].allowed);
    }
  }
}

TEST_CASE("a state that others have seen stands: a run never goes back beyond it") {
  write_file(kScene, growing_stack());
  Session session(kScene.string(), kAuto);
  double seen = 0;
  for (int k = 1; k <= 25; ++k) {
    session.advance_to(0.1 * k, never, [&] { CHECK(session.time() >= seen - 1e-9); });
    CHECK(session.time() == Approx(0.1 * k).margin(session.settings().dt));
    seen = session.time();
  }
  std::filesystem::remove(kScene);
}

TEST_CASE("auto keeps the options that are given, and a change of an option keeps the choice") {
  Session session("two-spheres", {{"response", "auto"}, {"precision", "double"}});
  CHECK(session.settings().precision == Precision::float64);
  const Response response = session.settings().response;
  const double dt = session.settings().dt;
  session.set("seed", "3");
  CHECK(session.settings().response == response);
  session.set("dt", "0.001");
  CHECK(session.settings().dt == 0.001);
  CHECK(session.settings().response == response);
  session.set("response", "penalty");
  CHECK(session.settings().response == Response::penalty);
  CHECK(session.choice() == nullptr);
  session.set("dt", "");
  session.set("response", "auto");
  CHECK(session.settings().response == response);
  CHECK(session.settings().dt == Approx(dt));
}

TEST_CASE("needs that nothing meets end auto with an error") {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "ballpit-impossible.toml";
  write_file(path,
             "[domain]\n[[spheres]]\nposition = [0.5, 0.5, 0.5]\nradius = 0.1\n[physics]\ngravity = [0, -1, 0]\n"
             "[needs]\nduration = 1\neffects = [\"contact-time\", \"momentum-order\"]\n");
  CHECK_THROWS_AS(Session(path.string(), kAuto), RunError);
  std::filesystem::remove(path);
}

TEST_CASE("a world that goes on from another one continues its time and its tally") {
  Session session("gas-dense", {{"response", "impulse"}}, true);
  session.advance_to(0.5, never);
  const Tally before = session.report().tally;
  REQUIRE(before.collisions > 0);
  session.set("dt", "0.002");
  CHECK(session.time() == Approx(0.5).margin(0.005));
  CHECK(session.report().tally.collisions == before.collisions);
  session.advance_to(1.0, never);
  CHECK(session.time() == Approx(1.0).margin(0.002));
  CHECK(session.report().tally.collisions > 1.5 * double(before.collisions));
  session.set("response", "event-driven");
  session.advance_to(1.2, never);
  CHECK(session.time() == Approx(1.2).margin(0.002));
  CHECK(session.report().tally.collisions > 2 * before.collisions);
}
