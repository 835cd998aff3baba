// SPDX-License-Identifier: MIT
// How fast errors fall with the step.
#include "lab/experiments/accuracy.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "measure/statistics.h"
#include "response/pair_force.h"

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
  return std::fabs(task_of(task).run(with_step(method_of(method), dt), 1, true).off);
}

/// Over twenty seeds, for tasks of means.
Mean mean_off(const std::string& task, const std::string& method, double dt) {
  std::vector<double> values;
  for (uint64_t seed = 1; seed <= 20; ++seed)
    values.push_back(task_of(task).run(with_step(method_of(method), dt), seed, true).off);
  return mean_of(values);
}

/// The order with which errors fall from a step to a quarter of it.
double order(const std::string& task, const std::string& method, double dt) {
  return std::log2(off(task, method, dt) / off(task, method, dt / 4)) / 2;
}

}  // namespace

TEST_CASE("the start of a contact limits the order of restitution: 3, 2.5 and 1 for Verlet, 2.5 and 2 for RK4") {
  const double damped = restitution_to_overlap_end(0.1);
  CHECK(order_of_restitution("velocity-verlet", "linear", 1) == Approx(3).margin(0.15));
  CHECK(order_of_restitution("velocity-verlet", "hertz", 1) == Approx(2.5).margin(0.15));
  CHECK(order_of_restitution("velocity-verlet", "linear", damped) == Approx(1).margin(0.15));
  CHECK(order_of_restitution("rk4", "hertz", 1) == Approx(2.5).margin(0.15));
  CHECK(order_of_restitution("rk4", "linear", damped) == Approx(2).margin(0.15));
}

TEST_CASE(
    "an oblique hit converges in first order by impulses and positions, and is exact with exact times of impact") {
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
  CHECK(order("stack-10", "position-based", 1.0 / 240) == Approx(2).margin(0.15));
  CHECK(order("stack-10", "penalty, velocity-verlet", 1.0 / 960) == Approx(2).margin(0.15));
}

TEST_CASE("kinematic spheres do not carry a stack, and event-driven ones collide in it without end") {
  CHECK(std::isinf(off("stack-10", "kinematic", 1.0 / 240)));
  CHECK(std::isinf(off("stack-10", "event-driven", 1.0 / 60)));
}

TEST_CASE("exact motion agrees with every closed form of a few spheres") {
  for (const char* task : {"ball", "hit", "bullet", "cradle"}) {
    INFO(task);
    CHECK(off(task, "event-driven", task_of(task).coarsest) < 1e-12);
  }
}

TEST_CASE("contacts at the end of coarse steps miss a bullet, fine steps and swept contacts do not") {
  CHECK(off("bullet", "impulse", 0.02) > 0.3);
  CHECK(off("bullet", "impulse", 0.02 / 64) < 1e-12);
  CHECK(off("bullet", "impulse, swept", 0.02) < 1e-12);
}

TEST_CASE("impulses pass the hit of a cradle on with short steps, springs with shorter ones") {
  CHECK(off("cradle", "impulse", 0.05) > 0.1);  // more than two gaps in a step
  CHECK(off("cradle", "impulse", 0.05 / 16) < 1e-12);
  CHECK(off("cradle", "penalty, velocity-verlet", 0.05 / 8) > 0.5);
  CHECK(off("cradle", "penalty, velocity-verlet", 0.05 / 64) < 1e-3);
}

TEST_CASE(
    "a ball's height converges in the first order by impulses, by springs of twenty steps a contact not by Verlet") {
  constexpr double kCoarse = 1.0 / 960, kFine = 1.0 / 30720;
  CHECK(std::log2(off("ball", "impulse", kCoarse) / off("ball", "impulse", kFine)) / 5 == Approx(1).margin(0.3));
  CHECK(off("ball", "penalty, velocity-verlet", kFine) > 2e-3);  // its error in restitution stays
  CHECK(off("ball", "penalty, rk4", kFine) < 1e-3);
}

TEST_CASE("paths converge to those of exact motion in the first order by impulses, and are exact by swept ones") {
  for (const char* task : {"paths-thin", "paths"}) {
    const double dt = task_of(task).coarsest;
    CHECK(order(task, "impulse", dt / 128) == Approx(1).margin(0.3));
    CHECK(off(task, "impulse, swept", dt / 64) < 1e-9);
  }
}

TEST_CASE("exact motion has the pressures, the cooling, the height and the shares that theory says, within chance") {
  struct Case {
    const char* task;
    double chance;  // largest standard error of the mean over the seeds
  };
  for (const Case& c : {Case{"gas-thin", 0.003}, Case{"gas", 0.004}, Case{"gas-dense", 0.004}, Case{"cooling", 0.015},
                        Case{"column", 0.01}, Case{"mixture", 0.01}}) {
    INFO(c.task);
    const Mean mean = mean_off(c.task, "event-driven", 0.02);
    CHECK(mean.error < c.chance);
    CHECK(std::fabs(mean.value) < 4 * mean.error);
  }
  CHECK(off("energy", "event-driven", 0.04) < 1e-12);
}

TEST_CASE("explicit Euler gains energy in a gas and in a column") {
  CHECK(off("energy", "penalty, explicit-euler", 0.01) > 1e-2);
  CHECK(off("energy", "penalty, velocity-verlet", 0.01) < 1e-3);
  const double verlet = off("column", "penalty, velocity-verlet", 0.0025);
  CHECK(verlet < 0.05);
  CHECK(off("column", "penalty, explicit-euler", 0.0025) > 5 * verlet);
}

TEST_CASE("quick runs use single precision for main methods only") {
  const Task& hit = task_of("hit");
  const auto all = methods_of(hit, false), quick = methods_of(hit, true);
  CHECK(all.size() == contact_methods().size());
  CHECK(quick.size() < all.size());
  for (const ContactMethod* method : quick) {
    CHECK((method->settings.precision == Precision::float64 || is_float_of_main(*method)));
  }
}

TEST_CASE("the Pareto front contains results that no other beats in error and time, without errors below chance") {
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
