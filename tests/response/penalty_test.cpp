// SPDX-License-Identifier: MIT
// The penalty response against the closed forms of a spring-dashpot contact, and cradles of springs.
#include <catch2/catch.hpp>

#include "response/pair_force.h"
#include "tests/support/hits.h"

using namespace ballpit;

namespace {

/// The measured properties of a head-on hit.
struct Hit {
  double restitution = 0, duration = 0, overlap = 0;
};

/// One hit that begins a fraction `phase` of a step after a step.
Hit run_hit(Scene scene, double speed, const std::string& contact_end, double dt, double phase) {
  const double gap = (2 + phase) * speed * dt;
  scene.bodies.position = head_on(speed, gap).bodies.position;
  Settings settings = settings_of("penalty", dt, "rk4");
  settings.contact_end = named<ContactEnd>(contact_end);
  const auto world = make_cpu_world(scene, settings);
  double largest = 0, begin = -1, end = -1, last = -gap;
  while (end < 0) {
    world->step();
    const Bodies bodies = world->bodies();
    const double overlap = 1 - (bodies.position[1].x - bodies.position[0].x);
    largest = std::max(largest, overlap);
    // The zeros, by linear interpolation between the steps around them.
    const double crossing = world->time() - dt * overlap / (overlap - last);
    if (begin < 0 && overlap > 0) begin = crossing;
    if (begin >= 0 && overlap <= 0) end = crossing;
    last = overlap;
  }
  return {parting_speed(*world) / speed, end - begin, largest};
}

/// The mean over hits that begin at different fractions of a step. If a dashpot's force jumps, the error of a single
/// hit is of first order in the step, and that of the mean of second order.
Hit run_hits(const Scene& scene, double speed, const std::string& contact_end, double dt) {
  constexpr int kPhases = 16;
  Hit mean;
  for (int k = 0; k < kPhases; ++k) {
    const Hit hit = run_hit(scene, speed, contact_end, dt, (k + 0.5) / kPhases);
    mean.restitution += hit.restitution / kPhases;
    mean.duration += hit.duration / kPhases;
    mean.overlap += hit.overlap / kPhases;
  }
  return mean;
}

}  // namespace

TEST_CASE("a linear spring-dashpot hit has the duration, restitution and overlap of its closed form") {
  // ω = √(k/m*), ζ from e: t_c = π/(ω√(1−ζ²)), δ_max = (v/ω)·exp(−ζ·acos ζ/√(1−ζ²)).
  const double e = GENERATE(1.0, 0.729248, 0.3);
  const double k = 1e4, v = 0.5, omega = std::sqrt(k / 0.5), zeta = damping_of(e, false);
  Scene scene = head_on(v, 1e-4);
  scene.physics.restitution = e;
  scene.physics.stiffness = k;
  const double root = std::sqrt(1 - zeta * zeta), expected = M_PI / (omega * root);
  const Hit hit = run_hits(scene, v, "overlap", expected / 1000);
  CHECK(hit.restitution == Approx(e).epsilon(1e-5));
  CHECK(hit.duration == Approx(expected).epsilon(1e-5));
  CHECK(hit.overlap == Approx(v / omega * std::exp(-zeta * (zeta > 0 ? std::acos(zeta) / root : 0))).epsilon(1e-5));
}

TEST_CASE("a contact that ends with its force has the restitution asked for, too") {
  Scene scene = head_on(0.5, 1e-4);
  scene.physics.restitution = 0.744079;
  scene.physics.stiffness = 1e4;
  const double duration = M_PI / std::sqrt(1e4 / 0.5);
  CHECK(run_hits(scene, 0.5, "force", duration / 1000).restitution == Approx(0.744079).epsilon(1e-5));
}

TEST_CASE("a dashpot damped by a tenth gives back more where the contact ends with its force") {
  // ζ = 0.1: e = 0.729248 to the end of the overlap; the same dashpot has 0.744079 to the end of the force.
  const double zeta = damping_of(0.729248, false);
  CHECK(restitution_to_force_end(zeta) == Approx(0.744079).margin(1e-6));
}

TEST_CASE("a Hertz hit has the overlap and duration of its closed form, and the restitution asked for") {
  // δ_max = (5·m*·v²/(4K))^0.4, t_c = 2.943275·δ_max/v; restitution: Antypov and Elliott 2011.
  const double stiffness = 1e6, v = 0.5, largest = std::pow(5 * 0.5 * v * v / (4 * stiffness), 0.4);
  Scene scene = head_on(v, 1e-4);
  scene.physics.law = "hertz";
  scene.physics.stiffness = stiffness;
  const double duration = 2.943275 * largest / v;
  const Hit hit = run_hits(scene, v, "overlap", duration / 1000);
  CHECK(hit.overlap == Approx(largest).epsilon(1e-5));
  CHECK(hit.duration == Approx(duration).epsilon(1e-5));
  CHECK(hit.restitution == Approx(1.0).epsilon(1e-6));
  for (const double e : {0.9, 0.5}) {
    scene.physics.restitution = e;
    CHECK(run_hits(scene, v, "overlap", duration / 1000).restitution == Approx(e).epsilon(1e-4));
    CHECK(run_hits(scene, v, "force", duration / 1000).restitution == Approx(e).epsilon(1e-4));
  }
}

TEST_CASE("the restitution of a Hertz hit does not depend on its speed", "[slow]") {
  Scene scene = head_on(0.05, 1e-5);
  scene.physics.law = "hertz";
  scene.physics.stiffness = 1e6;
  scene.physics.restitution = 0.6;
  CHECK(run_hits(scene, 0.05, "overlap", 1e-6).restitution == Approx(0.6).epsilon(1e-4));
}

TEST_CASE("a wall answers as a sphere of infinite mass: m* = m", "[slow]") {
  const double e = GENERATE(1.0, 0.5), k = 1e4, v = 0.5;
  const double duration = M_PI / std::sqrt(k / 2.0), dt = duration / 4000;
  double mean = 0;
  for (int phase = 0; phase < 16; ++phase) {
    Scene scene = wide_box(2);
    scene.physics.wall_restitution = e;
    scene.physics.stiffness = k;
    add_sphere(scene, {0, -1.5 + (2 + (phase + 0.5) / 16) * v * dt, 0}, {0, -v, 0}, 0.5, 2.0);
    const auto world = make_cpu_world(scene, settings_of("penalty", dt, "rk4"));
    step_until(*world, 2 * duration);
    mean += world->bodies().velocity[0].y / 16;
  }
  CHECK(mean == Approx(e * v).epsilon(1e-5));
}

TEST_CASE("shear slows what slides, by the momentum that the dashpot passes on") {
  // dv_t/dt = −(shear/m*)·v_t during the contact: v_t falls by exp(−shear·t_c/m*).
  Scene scene = head_on(0.5, 1e-4);
  scene.physics.stiffness = 1e6;
  scene.physics.shear = 20;
  scene.bodies.velocity[0].y = 0.001;  // so slow that the normal does not turn
  const double duration = M_PI / std::sqrt(1e6 / 0.5);
  const auto world = make_cpu_world(scene, settings_of("penalty", duration / 2000, "rk4"));
  step_until(*world, 3 * duration);
  const Bodies bodies = world->bodies();
  CHECK(bodies.velocity[0].y - bodies.velocity[1].y == Approx(0.001 * std::exp(-20 * duration / 0.5)).epsilon(0.01));
  CHECK(bodies.velocity[0].y + bodies.velocity[1].y == Approx(0.001).epsilon(1e-9));
}

TEST_CASE("a cradle of linear springs splits the momentum as verified, for three balls and five") {
  Scene scene = cradle(3);
  scene.physics.stiffness = 1e4;
  const auto three = make_cpu_world(scene, settings_of("penalty", 5e-5));
  step_until(*three, 0.5);
  const std::vector<double> v = speeds_along_x(*three), expected{-0.1303, 0.1502, 0.9800};
  for (size_t k = 0; k < v.size(); ++k) CHECK(v[k] == Approx(expected[k]).margin(1e-4));

  Scene longer = cradle(5);
  longer.physics.stiffness = 1e4;
  const auto five = make_cpu_world(longer, settings_of("penalty", 5e-5));
  step_until(*five, 0.5);
  const std::vector<double> w = speeds_along_x(*five), more{-0.1323, -0.0753, -0.0310, 0.2962, 0.9424};
  for (size_t k = 0; k < w.size(); ++k) CHECK(w[k] == Approx(more[k]).margin(1e-4));
}

TEST_CASE("a cradle of Hertz springs splits the momentum as verified, for three balls and five") {
  Scene scene = cradle(3);
  scene.physics.law = "hertz";
  scene.physics.stiffness = 1e6;
  const auto three = make_cpu_world(scene, settings_of("penalty", 2e-5));
  step_until(*three, 0.5);
  const std::vector<double> v = speeds_along_x(*three), expected{-0.0710, 0.0764, 0.9945};
  for (size_t k = 0; k < v.size(); ++k) CHECK(v[k] == Approx(expected[k]).margin(1e-4));

  Scene longer = cradle(5);
  longer.physics.law = "hertz";
  longer.physics.stiffness = 1e6;
  const auto five = make_cpu_world(longer, settings_of("penalty", 2e-5));
  step_until(*five, 0.5);
  const std::vector<double> w = speeds_along_x(*five), more{-0.0711, -0.0303, -0.0145, 0.1270, 0.9888};
  for (size_t k = 0; k < w.size(); ++k) CHECK(w[k] == Approx(more[k]).margin(1e-4));
}

TEST_CASE("a stack of springs rests with an overlap of (n − i)·m·g/k under level i") {
  // Levels counted from 0 at the floor: level i carries n − i spheres.
  const int n = 8;
  const double m = 0.5, g = 9.81, k = 1e4, r = 0.1;
  Scene scene;
  scene.domain.max = {1, 3, 1};
  scene.physics.gravity = {0, -g, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 0.3;
  scene.physics.stiffness = k;
  for (int i = 0; i < n; ++i) add_sphere(scene, {0.5, r + 2 * r * i, 0.5}, Vec3d(0), r, m);
  const auto world = make_cpu_world(scene, settings_of("penalty", 2e-4));
  step_until(*world, 10);
  const Bodies bodies = world->bodies();
  CHECK(r - bodies.position[0].y == Approx(n * m * g / k).epsilon(1e-4));
  for (int i = 1; i < n; ++i) {
    const double overlap = 2 * r - (bodies.position[i].y - bodies.position[i - 1].y);
    CHECK(overlap == Approx((n - i) * m * g / k).epsilon(1e-4));
  }
}

TEST_CASE("a report includes the energy in springs, so the sum stays the same in an elastic hit") {
  Scene scene = head_on(1.0, 1e-3);
  scene.physics.stiffness = 1e4;
  scene.physics.law = GENERATE("linear", "hertz");
  const auto world = make_cpu_world(scene, settings_of("penalty", 1e-5, "rk4"));
  double most = 0;
  for (int k = 0; k < 4000; ++k) {
    world->step();
    if (k % 50 != 0) continue;
    const Report report = world->report();
    most = std::max(most, report.elastic_energy);
    CHECK(report.kinetic_energy + report.elastic_energy == Approx(0.25).epsilon(1e-6));
  }
  CHECK(most > 0.24);
}
