// SPDX-License-Identifier: MIT
// The end check of every built-in scene: it runs for its duration and shows what its [needs] say.
#include <catch2/catch.hpp>

#include "app/session.h"
#include "scene/catalog.h"
#include "tests/app/run_program.h"

using namespace ballpit;

namespace {

double energy(const Report& report) { return report.kinetic_energy + report.potential_energy; }

/// Root mean square, weighted by mass.
double rms_speed(const Report& report, const Bodies& bodies) {
  double mass = 0;
  for (const double m : bodies.mass) mass += m;
  return std::sqrt(2 * report.kinetic_energy / mass);
}

double step_to(Session& session, double time) {
  session.advance_to(time, [] { return false; });
  return rms_speed(session.world().report(), session.world().bodies());
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
    const double energy_before = energy(session.world().report());
    const double speed = step_to(session, needs.duration);
    const Report report = session.world().report();
    INFO(info.name << ": overlap " << report.max_overlap << ", RMS speed " << speed << ", energy "
                   << energy(report) / energy_before << " of the start, " << report.seconds << " s");
    CHECK(report.time == Approx(needs.duration).margin(session.settings().dt));
    REQUIRE(needs.max_overlap);
    CHECK(report.max_overlap <= *needs.max_overlap);
    CHECK((needs.max_speed || needs.energy_tolerance));
    if (needs.max_speed) CHECK(speed <= *needs.max_speed);
    if (needs.energy_tolerance) {
      CHECK(std::abs(energy(report) - energy_before) <= *needs.energy_tolerance * energy_before);
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
