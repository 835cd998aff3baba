// SPDX-License-Identifier: MIT
// The integrators of the penalty response on springs, against theory. Figures that are not derived here were verified
// by independent experiment.
#include <catch2/catch.hpp>

#include "response/pair_force.h"
#include "tests/support/hits.h"

using namespace ballpit;

namespace {

constexpr double kStiffness = 1e4,
                 kGravity = 10;  // m = 1: ω = 100/s, a sphere at rest on the floor overlaps it by 1 mm

/// A sphere that never leaves the floor: an oscillator about its position of rest.
class Oscillator {
 public:
  Oscillator(const std::string& integrator, double omega_dt, double amplitude = 1e-4) {
    Scene scene = wide_box(10);
    scene.physics.gravity = {0, -kGravity, 0};
    scene.physics.stiffness = kStiffness;
    add_sphere(scene, {0, kRest + amplitude, 0}, Vec3d(0), 0.5, 1.0);
    Settings settings = settings_of("penalty", omega_dt / 100, integrator);
    settings.max_energy = settings.max_overlap = 1e15;  // some are here to be seen failing
    world_ = make_cpu_world(scene, settings);
  }

  /// ½v² + ½ω²y².
  double energy() const {
    const Bodies bodies = world_->bodies();
    const double y = bodies.position[0].y - kRest, v = bodies.velocity[0].y;
    return 0.5 * v * v + 0.5 * kStiffness * y * y;
  }

  void step(int steps = 1) {
    for (int k = 0; k < steps; ++k) world_->step();
  }

 private:
  static constexpr double kRest = -10 + 0.5 - kGravity / kStiffness;
  std::unique_ptr<World> world_;
};

struct Range {
  double least = 1e300, most = 0;
};

Range energy_range(const std::string& integrator, double omega_dt, int steps, double amplitude = 1e-4) {
  Oscillator oscillator(integrator, omega_dt, amplitude);
  Range range;
  for (int k = 0; k < steps; ++k) {
    oscillator.step();
    range.least = std::min(range.least, oscillator.energy());
    range.most = std::max(range.most, oscillator.energy());
  }
  return range;
}

}  // namespace

TEST_CASE("explicit Euler gains energy by 1 + ω²dt² in every step") {
  const double omega_dt = GENERATE(0.01, 0.1);
  Oscillator oscillator("explicit-euler", omega_dt);
  const double before = oscillator.energy();
  oscillator.step(20);
  CHECK(oscillator.energy() / before == Approx(std::pow(1 + omega_dt * omega_dt, 20)).epsilon(1e-9));
}

TEST_CASE("velocity Verlet's energy ranges over 1/(1 − ω²dt²/4) − 1 and does not drift") {
  const double omega_dt = GENERATE(0.1, 0.5, 0.9);
  const Range early = energy_range("velocity-verlet", omega_dt, 2000),
              late = energy_range("velocity-verlet", omega_dt, 20000);
  CHECK(early.most / early.least - 1 == Approx(1 / (1 - omega_dt * omega_dt / 4) - 1).epsilon(0.01));
  CHECK(late.most == Approx(early.most).epsilon(1e-3));
  CHECK(late.least == Approx(early.least).epsilon(1e-3));
}

TEST_CASE("symplectic Euler's energy ranges over ± ωdt/2 and does not drift") {
  const double omega_dt = GENERATE(0.02, 0.1);
  const Range early = energy_range("symplectic-euler", omega_dt, 2000),
              late = energy_range("symplectic-euler", omega_dt, 20000);
  const double middle = (early.most + early.least) / 2;
  CHECK((early.most - early.least) / (2 * middle) == Approx(omega_dt / 2).epsilon(0.01));
  CHECK(late.most == Approx(early.most).epsilon(1e-3));
}

TEST_CASE("symplectic Euler and velocity Verlet are stable below ωdt = 2, Runge-Kutta below 2.828, and not above") {
  const auto grows = [](const std::string& integrator, double omega_dt) {
    const Range range =
        energy_range(integrator, omega_dt, 300, 1e-12);  // so small that it grows a billionfold in contact
    return range.most > 1e4 * 0.5 * kStiffness * 1e-24;
  };
  CHECK_FALSE(grows("symplectic-euler", 1.98));
  CHECK(grows("symplectic-euler", 2.02));
  CHECK_FALSE(grows("velocity-verlet", 1.98));
  CHECK(grows("velocity-verlet", 2.02));
  CHECK_FALSE(grows("rk4", 2.80));
  CHECK(grows("rk4", 2.86));
}

namespace {

/// The mean error of restitution, |v'/v − e|, of hits that begin at different fractions of a step, with n steps a
/// contact.
double restitution_error(const std::string& integrator, const std::string& law, double e, int n) {
  const double v = 1.0, stiffness = law == "hertz" ? 1e6 : 1e4;
  const double zeta = damping_of(e, false);
  double duration = M_PI / std::sqrt(stiffness / 0.5 * (1 - zeta * zeta));
  if (law == "hertz") duration = 2.943275 * std::pow(5 * 0.5 * v * v / (4 * stiffness), 0.4) / v;
  const double dt = duration / n;
  constexpr int kPhases = 200;
  double mean = 0;
  for (int k = 0; k < kPhases; ++k) {
    Scene scene = head_on(v, (2 + (k + 0.5) / kPhases) * v * dt);
    scene.physics.law = law;
    scene.physics.stiffness = stiffness;
    scene.physics.restitution = e;
    const auto world = make_cpu_world(scene, settings_of("penalty", dt, integrator));
    step_until(*world, 2 * duration + 4 * dt);
    mean += std::abs(parting_speed(*world) / v - e) / kPhases;
  }
  return mean;
}

}  // namespace

TEST_CASE("restitution converges as the force's jump lets it: to third order at best, to first with a dashpot") {
  struct Row {
    const char *integrator, *law;
    double e, at_10, at_40, order;
  };
  const double damped = restitution_to_overlap_end(0.1);
  const Row row =
      GENERATE_COPY(Row{"velocity-verlet", "linear", 1.0, 1.0e-3, 1.6e-5, 3},
                    Row{"velocity-verlet", "hertz", 1.0, 1.7e-3, 4.8e-5, 2.5},
                    Row{"velocity-verlet", "linear", damped, 1.1e-2, 2.2e-3, 1},
                    Row{"rk4", "hertz", 1.0, 5.3e-4, 1.6e-5, 2.5}, Row{"rk4", "linear", damped, 2.3e-4, 4.8e-6, 2});
  const double coarse = restitution_error(row.integrator, row.law, row.e, 10);
  const double fine = restitution_error(row.integrator, row.law, row.e, 40);
  INFO(row.integrator << ", " << row.law << ", e = " << row.e << ": " << coarse << ", " << fine << ", order "
                      << std::log(coarse / fine) / std::log(4.0));
  CHECK(std::log(coarse / fine) / std::log(4.0) == Approx(row.order).margin(row.order == 2 ? 0.9 : 0.25));
  CHECK(coarse == Approx(row.at_10).epsilon(0.05));
  CHECK(fine == Approx(row.at_40).epsilon(0.05));
}
