// SPDX-License-Identifier: MIT
// How fast errors fall with the step: no faster than contacts let them.
#include "lab/experiments/accuracy.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "lab/experiments/results.h"
#include "simulate/response/damping.h"

using namespace ballpit;

namespace {

const Task& task_of(const std::string& name) {
  const auto found = std::find_if(tasks().begin(), tasks().end(), [&](const Task& task) { return task.name == name; });
  REQUIRE(found != tasks().end());
  return *found;
}

const ContactMethod& method_of(const std::string& name) {
  const auto& all = contact_methods();
  const auto found = std::find_if(all.begin(), all.end(), [&](const ContactMethod& m) { return m.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

double off(const std::string& task, const std::string& method, double dt) {
  return std::fabs(task_of(task).run(method_of(method), dt, 1, true).off);
}

/// At which order errors fall from one step to its quarter.
double order(const std::string& task, const std::string& method, double dt) {
  return std::log2(off(task, method, dt) / off(task, method, dt / 4)) / 2;
}

}  // namespace

TEST_CASE("the order of restitution is lost at the begin of a contact: 3, 2.5, and 1 of Verlet, 2.5 and 2 of RK4") {
  const double damped = restitution_to_overlap_end(0.1);
  CHECK(order_of_restitution("velocity-verlet", "linear", 1) == Approx(3).margin(0.15));
  CHECK(order_of_restitution("velocity-verlet", "hertz", 1) == Approx(2.5).margin(0.15));
  CHECK(order_of_restitution("velocity-verlet", "linear", damped) == Approx(1).margin(0.15));
  CHECK(order_of_restitution("rk4", "hertz", 1) == Approx(2.5).margin(0.15));
  CHECK(order_of_restitution("rk4", "linear", damped) == Approx(2).margin(0.15));
}

TEST_CASE(
    "an oblique hit converges in the first order by impulses and positions, and is exact where times of impact are") {
  CHECK(order("hit", "impulse", 0.025) == Approx(1).margin(0.15));
  CHECK(order("hit", "position-based", 0.025) == Approx(1).margin(0.15));
  CHECK(order("hit", "penalty, rk4", 0.0125) == Approx(1).margin(0.15));  // of a contact's duration
  CHECK(off("hit", "impulse, swept", 0.1) < 1e-13);
  CHECK(off("hit", "event-driven", 0.1) < 1e-13);
}

TEST_CASE(
    "explicit Euler does not converge where springs get stiffer with the step, and kinematic spheres exchange "
    "nothing") {
  CHECK(off("hit", "penalty, explicit-euler", 0.001) > 0.05);
  CHECK(off("hit", "penalty, velocity-verlet", 0.001) < 0.02);
  CHECK(off("hit", "kinematic", 0.001) > 0.3);
}

TEST_CASE("a stack's overlap falls in the second order of the step by springs and positions") {
  CHECK(order("stack", "position-based", 1.0 / 240) == Approx(2).margin(0.15));
  CHECK(order("stack", "penalty, velocity-verlet", 1.0 / 960) == Approx(2).margin(0.15));
}

TEST_CASE("kinematic spheres do not carry a stack, and event-driven ones collide in it without end") {
  CHECK(std::isinf(off("stack", "kinematic", 1.0 / 240)));
  CHECK(std::isinf(off("stack", "event-driven", 1.0 / 60)));
}

TEST_CASE("paths converge to those of exact motion in the first order by impulses, and are exact by swept ones") {
  CHECK(order("paths", "impulse", 1.25 / 128) == Approx(1).margin(0.3));
  CHECK(off("paths", "impulse, swept", 1.25 / 64) < 1e-10);
}

TEST_CASE("the Pareto front holds those that nobody beats in error and in time, and no error below chance") {
  const auto result = [](double error, double seconds) {
    return Result{&contact_methods().front(), 0.1, error, 0, {seconds, seconds, seconds, seconds}};
  };
  const double failed = std::numeric_limits<double>::infinity();
  const std::vector<Result> all{result(1e-3, 5), result(0.1, 1),  result(0.2, 2),     result(0.01, 2),
                                result(0.02, 3), result(1e-5, 6), result(failed, 0.1)};
  const auto errors_of = [](const std::vector<Result>& front) {
    std::vector<double> errors;
    for (const Result& r : front) errors.push_back(r.error);
    return errors;
  };
  CHECK(errors_of(front_of(all, 0)) == std::vector<double>{0.1, 0.01, 1e-3, 1e-5});
  CHECK(errors_of(front_of(all, 5e-3)) == std::vector<double>{0.1, 0.01, 5e-3});
}
