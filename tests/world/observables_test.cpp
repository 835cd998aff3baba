// SPDX-License-Identifier: MIT
// Observables of states small enough to be worked out by hand.
#include "world/observables.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "core/random.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

const Observable& observable_named(std::string_view name) {
  for (const Observable& observable : observables()) {
    if (observable.name == name) return observable;
  }
  throw std::runtime_error("no observable " + std::string(name));
}

ObservedValue values(std::string_view name, const Observation& observation) {
  return measure(observable_named(name), observation);
}

/// The value of one that has one number.
double value(std::string_view name, const Observation& observation) {
  const ObservedValue all = values(name, observation);
  INFO(name);
  REQUIRE(all.size() == 1);
  return all[0];
}

/// Two spheres of 1 and 3 kg, 2 m/s apart along x, in a box of 2 m × 4 m × 5 m whose floor lies at y = −1 m; after 10 s.
Observation two_spheres(Boundary boundary, int dimensions = 3) {
  Scene scene;
  add_sphere(scene, {0, 0, 0}, {3, 0, 0}, 0.1, 1.0);
  add_sphere(scene, {1, 2, 0}, {1, 0, 0}, 0.1, 3.0);
  Observation observation;
  observation.domain = {{0, -1, 0}, {2, 3, dimensions == 2 ? 0 : 5}, boundary, dimensions};
  observation.bodies = scene.bodies;
  observation.report.count = 2;
  observation.report.time = 10;
  return observation;
}

/// A gas at rest as a whole: every velocity has its opposite.
Observation gas(int dimensions, int pairs, Boundary boundary = Boundary::periodic) {
  Random random(4);
  Scene scene;
  for (int i = 0; i < pairs; ++i) {
    const Vec3d v = random.uniform() * random.direction(dimensions);
    add_sphere(scene, Vec3d(0.5), v);
    add_sphere(scene, Vec3d(0.25), -v);
  }
  Observation observation;
  observation.domain = {Vec3d(0), dimensions == 2 ? Vec3d(2, 3, 0) : Vec3d(2, 3, 4), boundary, dimensions};
  observation.bodies = scene.bodies;
  observation.report.time = 2;
  return observation;
}

}  // namespace

TEST_CASE("every observable has a name of its own, a label, units and a sentence that says how it is made") {
  std::set<std::string_view> names;
  for (const Observable& observable : observables()) {
    INFO(observable.name);
    CHECK(names.insert(observable.name).second);
    CHECK(observable.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string_view::npos);
    CHECK_FALSE(observable.label.empty());
    CHECK_FALSE(observable.unit.empty());
    CHECK_FALSE(observable.planar_unit.empty());
    CHECK(observable.estimator.size() > 2);
    CHECK(observable.compute != nullptr);
  }
  CHECK(names.size() == 19);
}

TEST_CASE("observables that need no tally are the same with any tally, and the others are not") {
  Observation observation = two_spheres(Boundary::walls);
  observation.missed_contacts = [] { return 7; };
  for (const Observable& observable : observables()) {
    INFO(observable.name);
    observation.report.tally = {};
    const ObservedValue before = measure(observable, observation);
    observation.report.tally = {11, 2.0, 3.0, 7};
    CHECK((measure(observable, observation) != before) == observable.needs_tally);
  }
}

TEST_CASE("energies, momentum and overlap are those of the report") {
  Observation observation = two_spheres(Boundary::walls);
  observation.report.kinetic_energy = 5;
  observation.report.potential_energy = -7;
  observation.report.elastic_energy = 0.5;
  observation.report.momentum = {1, 2, 3};
  observation.report.max_overlap = 0.125;
  CHECK(value("kinetic-energy", observation) == 5);
  CHECK(value("potential-energy", observation) == -7);
  CHECK(value("elastic-energy", observation) == 0.5);
  CHECK(value("total-energy", observation) == -1.5);
  CHECK(values("momentum", observation) == ObservedValue{1, 2, 3});
  CHECK(value("max-overlap", observation) == 0.125);
}

TEST_CASE("temperature is 2K/(d·n) within walls, where all motion is thermal") {
  // K = 9/2 + 3/2 = 6 J
  CHECK(value("temperature", two_spheres(Boundary::walls)) == Approx(2.0));
  CHECK(value("temperature", two_spheres(Boundary::open_top)) == Approx(2.0));
  CHECK(value("temperature", two_spheres(Boundary::walls, 2)) == Approx(3.0));
}

TEST_CASE("temperature in a periodic domain is that of the motion about the centre of mass, over d·(n − 1)") {
  // The centre moves at 6/4 = 1.5 m/s. K about it = 1.5²/2 + 3·0.5²/2 = 1.5 J
  CHECK(value("temperature", two_spheres(Boundary::periodic)) == Approx(1.0));
  CHECK(value("temperature", two_spheres(Boundary::periodic, 2)) == Approx(1.5));
  Observation moved = two_spheres(Boundary::periodic);
  for (Vec3d& v : moved.bodies.velocity) v += Vec3d(100, -50, 20);
  CHECK(value("temperature", moved) == Approx(1.0));
}

TEST_CASE("moments of the velocity are means over spheres") {
  // squares 9 and 1, fourth powers 81 and 1
  CHECK(value("mean-square-speed", two_spheres(Boundary::walls)) == Approx(5.0));
  CHECK(value("mean-square-speed", two_spheres(Boundary::periodic)) == Approx(5.0));
  CHECK(value("velocity-moment", two_spheres(Boundary::walls)) == Approx(41.0 / 25));
  // about the centre of mass: 1.5 and 0.5 m/s, squares 2.25 and 0.25, fourth powers 5.0625 and 0.0625
  CHECK(value("velocity-moment", two_spheres(Boundary::periodic)) == Approx(2.5625 / 1.5625));
}

TEST_CASE("the velocity moment is 1 for equal speeds, and 1 + 2/d for Maxwell's distribution") {
  for (const int dimensions : {2, 3}) {
    Observation observation = gas(dimensions, 100'000);
    Random random(9);
    for (size_t i = 0; i < observation.bodies.velocity.size(); i += 2) {
      Vec3d v(0.0);  // normal deviates by Box and Muller
      for (int axis = 0; axis < dimensions; ++axis) {
        v[axis] = std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * std::numbers::pi * random.uniform());
      }
      observation.bodies.velocity[i] = v;
      observation.bodies.velocity[i + 1] = -v;
    }
    CHECK(value("velocity-moment", observation) == Approx(1 + 2.0 / dimensions).epsilon(0.01));
    for (Vec3d& v : observation.bodies.velocity) v = normalize(v);
    CHECK(value("velocity-moment", observation) == Approx(1.0));
  }
}

TEST_CASE("each collision counts for both of its spheres") {
  Observation observation = two_spheres(Boundary::walls);
  observation.report.tally.collisions = 1;
  CHECK(value("collisions-per-sphere", observation) == 1);
  CHECK(value("collision-rate", observation) == Approx(0.1));
}

TEST_CASE("collisions are those of spheres and those with walls, of which only the former have a rate") {
  Observation observation = two_spheres(Boundary::walls);
  observation.report.tally.wall_hits = 5;
  CHECK(value("collisions", observation) == 5);
  CHECK(value("collision-rate", observation) == 0);
  observation.report.tally.collisions = 2;
  CHECK(value("collisions", observation) == 7);
  CHECK(value("collisions-per-sphere", observation) == 2);
}

TEST_CASE("pressure is that of an ideal gas, and the virial over time") {
  Observation observation = two_spheres(Boundary::walls);
  CHECK(value("pressure", observation) == Approx(2 * 2.0 / 40));  // n·kT/V
  CHECK(value("compressibility", observation) == Approx(1.0));
  observation.report.tally.virial = 60;  // over d·T = 30 s: 2 J
  CHECK(value("pressure", observation) == Approx(6.0 / 40));
  CHECK(value("compressibility", observation) == Approx(1.5));
}

TEST_CASE("pressure in the plane is a force on a length") {
  Observation observation = two_spheres(Boundary::walls, 2);
  observation.report.tally.virial = 60;                                  // over d·T = 20 s: 3 J
  CHECK(value("pressure", observation) == Approx((2 * 3.0 + 3.0) / 8));  // an area of 2 m × 4 m
  CHECK(unit_of(observable_named("pressure"), observation.domain) == "N/m");
  CHECK(unit_of(observable_named("pressure"), two_spheres(Boundary::walls).domain) == "Pa");
  CHECK(unit_of(observable_named("floor-force"), observation.domain) == "N");
}

TEST_CASE("the compressibility of a gas without collisions is 1") {
  for (const int dimensions : {2, 3}) {
    CHECK(value("compressibility", gas(dimensions, 50)) == Approx(1.0));
    CHECK(value("compressibility", gas(dimensions, 50, Boundary::walls)) == Approx(1.0));
  }
}

TEST_CASE("collision rate and compressibility agree with each other as kinetic theory says") {
  // n spheres, m = σ = kT = 1. A pair parts with a mean impulse of √(π·m·kT), so that the virial of C collisions is C·√π.
  // Then Γ = (6/√π)·(Z − 1) if, and only if, both count collisions alike. Γ = 0.81149 is hard spheres at density 0.1.
  constexpr double kRate = 0.81149, kCompressibility = 1.239720;
  Observation observation = gas(3, 500'000);
  const double kT = value("temperature", observation);
  for (Vec3d& v : observation.bodies.velocity) v /= std::sqrt(kT);
  const double collisions = kRate * observation.report.time * 1e6 / 2;
  observation.report.tally = {std::llround(collisions), collisions * std::sqrt(std::numbers::pi), 0};
  CHECK(value("collision-rate", observation) == Approx(kRate).epsilon(1e-6));
  CHECK(value("compressibility", observation) == Approx(kCompressibility).epsilon(1e-5));
}

TEST_CASE("the floor force is the impulse that the floor took, over time") {
  Observation observation = two_spheres(Boundary::open_top);
  observation.report.tally.floor_impulse = 25;
  CHECK(value("floor-force", observation) == Approx(2.5));
}

TEST_CASE("the height of the centre of mass is above the floor") {
  CHECK(value("centre-of-mass-height", two_spheres(Boundary::walls)) == Approx(1.5 + 1));
}

TEST_CASE("missed contacts are searched for when they are asked for, and only then") {
  Observation observation = two_spheres(Boundary::walls);
  int searches = 0;
  observation.missed_contacts = [&] { return 10 + ++searches; };
  value("max-overlap", observation);
  CHECK(searches == 0);
  CHECK(value("missed-contacts", observation) == 11);
  CHECK(searches == 1);
}

TEST_CASE("what does not exist has no value") {
  Observation start = two_spheres(Boundary::walls);
  start.report.time = 0;
  for (const char* name : {"collision-rate", "pressure", "compressibility", "floor-force"}) {
    INFO(name);
    CHECK(values(name, start).empty());
  }
  CHECK(value("collisions-per-sphere", start) == 0);
  CHECK(values("floor-force", two_spheres(Boundary::periodic)).empty());
  CHECK(values("centre-of-mass-height", two_spheres(Boundary::periodic)).empty());
  CHECK(values("pressure", two_spheres(Boundary::open_top)).empty());
  CHECK(values("compressibility", two_spheres(Boundary::open_top)).empty());
  CHECK(values("missed-contacts", start).empty());  // nobody to search
}

TEST_CASE("one sphere has no temperature, and spheres at rest have no moment and no compressibility") {
  for (const Boundary boundary : {Boundary::walls, Boundary::periodic}) {
    Observation one = two_spheres(boundary);
    one.bodies.resize(1);
    for (const char* name : {"temperature", "pressure", "compressibility"}) CHECK(values(name, one).empty());
    CHECK(value("mean-square-speed", one) == 9);
    Observation resting = two_spheres(boundary);
    for (Vec3d& v : resting.bodies.velocity) v = Vec3d(0.0);
    CHECK(value("temperature", resting) == 0);
    CHECK(value("pressure", resting) == 0);
    for (const char* name : {"velocity-moment", "compressibility"}) CHECK(values(name, resting).empty());
  }
}

TEST_CASE("values that are not finite are none, whatever they come from") {
  Observation observation = two_spheres(Boundary::walls);
  observation.report.momentum = {0, std::numeric_limits<double>::infinity(), 0};
  observation.report.max_overlap = std::numeric_limits<double>::quiet_NaN();
  CHECK(values("momentum", observation).empty());
  CHECK(values("max-overlap", observation).empty());
}
