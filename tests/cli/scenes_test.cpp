// SPDX-License-Identifier: MIT
// The end check of every built-in scene: it runs for its duration and shows what its [needs] say.
#include <cmath>

#include <catch2/catch.hpp>

#include "choose/needs_meter.h"
#include "core/error.h"
#include "scene/read_scene.h"
#include "show/session.h"
#include "tests/support/run_program.h"
#include "world/observables.h"

using namespace ballpit;

namespace {

using Given = std::vector<GivenOption>;

double step_to(Session& session, double time) {
  session.advance_to(time, [] { return false; });
  return rms_speed(session.world().report(), session.world().bodies());
}

double observed(Session& session, std::string_view name) {
  for (const Observable& observable : observables()) {
    if (observable.name != name) continue;
    return measure(observable, {session.scene().domain, session.world().bodies(), session.world().report()}).at(0);
  }
  throw std::out_of_range(std::string(name));
}

/// A scene at its end, with these options and a tally.
Session at_its_end(std::string_view scene, const Given& given = {}) {
  Session session(scene, given, true);
  step_to(session, session.scene().needs.duration);
  return session;
}

/// [N]
double weight_of_all(Session& session) {
  double mass = 0;
  for (const double m : session.world().bodies().mass) mass += m;
  return mass * length(session.scene().physics.gravity);
}

void check_inside(const Domain& domain, const Bodies& bodies) {
  for (const Vec3d& p : bodies.position) {
    for (int axis = 0; axis < domain.dimensions; ++axis) {
      REQUIRE(p[axis] >= domain.min[axis]);
      if (domain.boundary != Boundary::open_top || axis != 1) REQUIRE(p[axis] <= domain.max[axis]);
    }
  }
}

}  // namespace

TEST_CASE("every built-in scene shows at its end what it needs") {
  for (const SceneInfo& info : built_in_scenes()) {
    Session session(info.name, {});
    if (is_sanitized() && session.world().report().count > 10'000) continue;  // minutes; the others run the same code
    const Needs& needs = session.scene().needs;
    REQUIRE(needs.max_overlap);
    CHECK(tolerances_of(needs).size() >= 2);
    NeedsMeter meter(session.scene(), needs, session.world());
    session.advance_to(needs.duration, [&] {
      meter.look(session.world());
      return false;
    });
    const Report report = session.world().report();
    CHECK(report.time == Approx(needs.duration).margin(session.settings().dt));
    const std::vector<double> errors = meter.errors(session.world(), {});
    for (size_t k = 0; k < errors.size(); ++k) {
      const Tolerance tolerance = tolerances_of(needs)[k];
      INFO(info.name << ", " << tolerance.name << ", " << report.seconds << " s");
      CHECK(errors[k] <= tolerance.allowed);
    }
    check_inside(session.scene().domain, session.world().bodies());
  }
}

TEST_CASE("the default scene still bounces after three seconds") {
  Session session(kDefaultScene, {});
  CHECK(step_to(session, 3.0) > 1.0);
}

TEST_CASE("the two spheres part as the reduced mass says: only the speed along the line of centres changes") {
  // Equal masses with e = 1 exchange it. They touch 1 m apart, 0.5 m of it across: the line of centres is 30°
  // off x.
  Session session("two-spheres", {});
  step_to(session, session.scene().needs.duration);
  const Bodies bodies = session.world().bodies();
  CHECK(bodies.velocity[0].x == Approx(1 - 2 * 0.75).margin(0.01));
  CHECK(bodies.velocity[0].y == Approx(-2 * std::sqrt(0.75) * 0.5).margin(0.01));
  CHECK(bodies.velocity[1].x == Approx(-bodies.velocity[0].x));
  CHECK(bodies.velocity[1].y == Approx(-bodies.velocity[0].y));
  CHECK(bodies.velocity[0].z == 0.0);
}

TEST_CASE("every scene runs with every response") {
  for (const SceneInfo& info : built_in_scenes()) {
    for (const char* response : {"kinematic", "impulse", "penalty", "position-based", "event-driven"}) {
      INFO(info.name << ", " << response);
      Given given{{"response", response}};
      if (response == std::string("penalty")) given.push_back({"dt", "0.00002"});  // contacts are short
      Session session(info.name, given);
      if (is_sanitized() && session.world().report().count > 10'000) continue;
      step_to(session, 0.02);
      CHECK(session.world().report().max_overlap < 0.3);
    }
  }
}

TEST_CASE("the bouncing ball touches the floor at the times of theory") {
  // tₙ follows from height and speed at any time between bounces n and n + 1: it left the floor at eⁿ·√(2·g·h₀).
  const double g = 9.81, e = 0.8, first = std::sqrt(2 / g);
  Session session("bouncing-ball", {});
  for (const auto& [n, between] : {std::pair{2, 1.5}, std::pair{5, 2.7}}) {
    step_to(session, between);
    const Bodies ball = session.world().bodies();
    const double speed = std::pow(e, n) * std::sqrt(2 * g), flown = (speed - ball.velocity[0].y) / g;
    CHECK(session.world().time() - flown ==
          Approx(first * (1 + 2 * e * (1 - std::pow(e, n - 1)) / (1 - e))).epsilon(1e-9));
    CHECK(ball.position[0].y - ball.radius[0] == Approx(speed * flown - g / 2 * flown * flown).epsilon(1e-9));
  }
  step_to(session, first * (1 + e) / (1 - e) - 0.05);
  CHECK(std::abs(session.world().bodies().velocity[0].y) > 0.01);
  step_to(session, first * (1 + e) / (1 - e) + 0.01);
  CHECK(std::abs(session.world().bodies().velocity[0].y) < 0.001);
}

TEST_CASE("the oblique pair exchanges (1 + e) times reduced mass times speed of approach, along the line of centres") {
  Session session = at_its_end("oblique-pair");
  const Bodies bodies = session.world().bodies();
  CHECK(length(bodies.velocity[0] - Vec3d(2 - 1.92 * 0.8, 1.92 * 0.6, 0)) < 1e-12);
  CHECK(length(bodies.velocity[1] - Vec3d(1.92 / 3 * 0.8, -1.92 / 3 * 0.6, 0)) < 1e-12);
  Session late = at_its_end("oblique-pair", {{"response", "impulse"}});  // a contact is found up to dt late
  CHECK(length(late.world().bodies().velocity[0] - bodies.velocity[0]) < 0.02);
}

TEST_CASE("in the cradle springs hand all but a hundredth to the last ball, single collisions all of it") {
  Session springs = at_its_end("cradle"), collisions = at_its_end("cradle", {{"response", "event-driven"}});
  const double hertz[] = {-0.0711, -0.0303, -0.0145, 0.1270, 0.9888}, one_by_one[] = {0, 0, 0, 0, 1};
  for (size_t i = 0; i < 5; ++i) {
    CHECK(springs.world().bodies().velocity[i].x == Approx(hertz[i]).margin(0.001));
    CHECK(collisions.world().bodies().velocity[i].x == Approx(one_by_one[i]).margin(1e-12));
  }
  CHECK(energy_of(collisions.world().report()) == Approx(energy_of(springs.world().report())).epsilon(0.001));
}

TEST_CASE("the stack sinks in by as much as gravity moves a sphere in a substep, times its height") {
  const double gh2 = 9.81 / (2400.0 * 2400.0), radius = 0.125;
  Session positions = at_its_end("stack");
  CHECK(positions.world().report().max_overlap * radius >= 0.99 * 9 * gh2);
  CHECK(positions.world().report().max_overlap * radius <= 1.01 * 16 * gh2);
  CHECK(observed(positions, "floor-force") == Approx(weight_of_all(positions)).epsilon(1e-4));
  // With springs the floor's carries the weight of all.
  Session springs = at_its_end("stack", {{"response", "penalty"}, {"dt", "0.001"}});
  CHECK(springs.world().report().max_overlap * radius == Approx(weight_of_all(springs) / 1e6).epsilon(0.001));
}

TEST_CASE("a light sphere is pressed into the floor by the weight of what it carries") {
  Session session = at_its_end("mass-ratio");
  const Bodies bodies = session.world().bodies();
  CHECK(bodies.mass[5] == Approx(64 * bodies.mass[4]));
  for (const size_t light : {0, 2, 4}) {
    const double load = (bodies.mass[light] + bodies.mass[light + 1]) * 9.81;
    CHECK(bodies.radius[light] - bodies.position[light].y == Approx(load / 4e6).epsilon(0.01));
  }
  CHECK(observed(session, "floor-force") == Approx(weight_of_all(session)).epsilon(0.001));
}

TEST_CASE("the bullet meets the wall where contacts are swept, and else flies through it and out of the domain") {
  Session swept("bullet", {});
  step_to(swept, 0.025);
  CHECK(swept.world().bodies().velocity[0].x < 50);
  Session stepwise("bullet", {{"swept", "off"}});
  step_to(stepwise, 0.035);
  CHECK(stepwise.world().bodies().velocity[0].x == 100);
  CHECK(stepwise.world().bodies().position[0].x > 1);
  CHECK_THROWS_WITH(step_to(stepwise, 0.05), Catch::Contains("sphere 0 left the domain"));
}

TEST_CASE("the gases have the pressure and the collision rate of hard spheres") {
  // Z and Γ of 800 and 500 spheres (Kolafa, Labík, Malijevský 2004, corrected for their number; model.md). The bounds
  // are four standard errors.
  Session thin = at_its_end("gas-thin"), dense = at_its_end("gas-dense");
  CHECK(observed(thin, "compressibility") == Approx(1.23946).margin(0.006));
  CHECK(observed(dense, "compressibility") == Approx(3.26737).margin(0.034));
  const double speed = std::sqrt(1 / 3.0), diameter = 0.1;
  CHECK(observed(thin, "collision-rate") == Approx(0.811 * speed / diameter).epsilon(0.02));
  CHECK(observed(dense, "collision-rate") == Approx(7.68 * speed / diameter).epsilon(0.02));
}

TEST_CASE("the cooling gas cools as Haff's law says") {
  // T = T₀·(1 + t/τ)^−2, τ = 6/((1 − e²)·Γ₀), Γ₀ = 0.8115·√(kT₀/m)/σ; the mean of three gases.
  const double tau = 6 / ((1 - 0.81) * 0.8115 * std::sqrt(1 / 3.0) / 0.1);
  double half_way = 0, end = 0;
  for (const char* seed : {"1", "2", "3"}) {
    Session session("cooling-gas", {{"seed", seed}});
    const double start = observed(session, "temperature");
    step_to(session, 10);
    half_way += observed(session, "temperature") / start / 3;
    step_to(session, 20);
    end += observed(session, "temperature") / start / 3;
  }
  CHECK(half_way == Approx(std::pow(1 + 10 / tau, -2)).epsilon(0.03));
  CHECK(end == Approx(std::pow(1 + 20 / tau, -2)).epsilon(0.03));
}

TEST_CASE("in the column the floor carries the weight of all, and heights are as the pressure says") {
  // Σ m·g·(y − r) = ∫P dV = N·kT + W/(3·T): what lies above each height presses on it.
  Session session("column", {}, true);
  double moment = 0, thermal = 0;
  const int samples = 100;
  for (int k = 1; k <= samples; ++k) {
    step_to(session, 0.2 * k);
    moment += weight_of_all(session) * (observed(session, "centre-of-mass-height") - 0.03) / samples;
    thermal += 200 * observed(session, "temperature") / samples;
  }
  const Report report = session.world().report();
  CHECK(observed(session, "floor-force") == Approx(weight_of_all(session)).epsilon(0.005));
  CHECK(moment == Approx(thermal + report.tally.virial / (3 * report.time)).epsilon(0.03));
  CHECK(moment > 1.05 * thermal);  // spheres need room: the column is higher than an ideal gas's
}

TEST_CASE("two balls and a wall count the digits of π, and then both fly away from it") {
  // Galperin 2003: ⌊π·√ratio⌋ for a ratio of 100^k, and ⌈π/atan(√(1/ratio))⌉ − 1 for any.
  const auto count = [](const char* ratio) {
    Session session = at_its_end("pi", {{"mass-ratio", ratio}});
    const Bodies end = session.world().bodies();
    CHECK(end.velocity[0].x > -1e-6);
    CHECK(end.velocity[1].x > end.velocity[0].x);
    CHECK(end.position[1].x + end.radius[1] < session.scene().domain.max.x);
    return observed(session, "collisions");
  };
  CHECK(count("1") == 3);
  CHECK(count("100") == 31);
  CHECK(count("1e4") == 314);
  CHECK(count("1e6") == 3141);
  CHECK(count("1e8") == 31415);
  CHECK(count("7") == 8);     // π/atan(√(1/7)) = 8.69
  CHECK(count("1e3") == 99);  // 99.36
}

TEST_CASE("the mass ratio starts a scene again, as its count does") {
  Session session("pi", {}, true);
  step_to(session, 3);
  session.set("mass-ratio", "1e4");
  CHECK(session.time() == 0);
  CHECK(session.world().bodies().mass[1] == 1e4);
  CHECK_THROWS_AS(session.set("mass-ratio", "0"), UserError);
  session.set("mass-ratio", "");
  CHECK(session.world().bodies().mass[1] == 100);
}

TEST_CASE("the floor carries the weight of the dense bed") {
  Session session = at_its_end("dense-bed");
  CHECK(observed(session, "floor-force") == Approx(weight_of_all(session)).epsilon(0.001));
  const double filled = 1000 * 4.18879 * 0.06 * 0.06 * 0.06 / (2 * (2 * observed(session, "centre-of-mass-height")));
  CHECK(filled > 0.55);
  CHECK(filled < 0.68);
}
