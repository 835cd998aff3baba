// SPDX-License-Identifier: MIT
// What settings cost and what they get right, as it is played.
#include "show/trade_off.h"

#include <catch2/catch.hpp>

#include "show/demo.h"

using namespace ballpit;

namespace {

/// A state after so many steps of 0.1 s, each of which took `seconds`.
Report state(int64_t steps, double seconds, double overlap, double energy = 1) {
  Report report;
  report.steps = steps;
  report.time = 0.1 * static_cast<double>(steps);
  report.seconds = seconds * static_cast<double>(steps);
  report.max_overlap = overlap;
  report.kinetic_energy = energy;
  return report;
}

/// A trial that was played for twenty steps.
void play(TradeOff& trade_off, const std::string& dt, double seconds, double overlap) {
  trade_off.begin({{"dt", dt}}, {});
  trade_off.observe(state(0, seconds, 0));
  trade_off.observe(state(20, seconds, overlap));
}

std::vector<std::string> labels(const TradeOff& trade_off, const std::vector<int>& indices) {
  std::vector<std::string> result;
  for (const int k : indices) result.push_back(trade_off.trials()[static_cast<size_t>(k)].label());
  return result;
}

}  // namespace

TEST_CASE("a trial costs what its steps took, and errs by the worst that was seen") {
  TradeOff trade_off;
  trade_off.begin({{"dt", "0.1"}}, {});
  trade_off.observe(state(5, 0.02, 0.9, 2));  // what was before does not count
  trade_off.observe(state(15, 0.02, 0.3, 3));
  trade_off.observe(state(25, 0.02, 0.1, 1.5));
  const Played& trial = trade_off.trials().at(0);
  CHECK(trial.steps == 20);
  CHECK(trial.cost() == Approx(0.2));
  CHECK(trial.overlap == 0.3);
  CHECK(trial.drift == Approx(0.5));
  CHECK(trial.label() == "--dt 0.1");
}

TEST_CASE("the front holds the trials that no other beats") {
  TradeOff trade_off;
  play(trade_off, "1", 0.01, 0.5);
  play(trade_off, "2", 0.02, 0.6);  // slower and worse
  play(trade_off, "3", 0.04, 0.1);
  play(trade_off, "4", 0.04, 0.2);  // as slow and worse
  play(trade_off, "5", 0.08, 0.1);  // slower and no better
  CHECK(labels(trade_off, trade_off.front(played_errors()[0])) == std::vector<std::string>{"--dt 1", "--dt 3"});
}

TEST_CASE("settings that were played before go on, and those that were hardly played are dropped") {
  TradeOff trade_off;
  play(trade_off, "1", 0.01, 0.5);
  trade_off.begin({{"dt", "2"}}, {});
  trade_off.observe(state(0, 1, 0));
  trade_off.observe(state(3, 1, 0));
  play(trade_off, "1", 0.03, 0.2);
  REQUIRE(trade_off.trials().size() == 1);
  CHECK(trade_off.current() == 0);
  CHECK(trade_off.trials()[0].steps == 40);
  CHECK(trade_off.trials()[0].cost() == Approx(0.2));
  CHECK(trade_off.trials()[0].overlap == 0.5);
}

TEST_CASE("other physics are another trial") {
  TradeOff trade_off;
  play(trade_off, "1", 0.01, 0.5);
  Physics stiff;
  stiff.stiffness *= 10;
  trade_off.begin({{"dt", "1"}}, stiff);
  CHECK(trade_off.current() == 1);
}

TEST_CASE("a demonstration tries what it plays, and goes back to it") {
  Demo demo("stack", {});
  const auto play = [&] {
    demo.report();
    for (int k = 0; k < 20; ++k) demo.step();
    demo.report();
  };
  play();
  demo.set("response", "penalty");
  play();
  demo.set("substeps", "4");
  play();
  REQUIRE(demo.trade_off.trials().size() == 3);
  for (const Played& trial : demo.trade_off.trials()) {
    CHECK(trial.steps == 20);
    CHECK(trial.cost() > 0);
    CHECK(trial.overlap > 0);
  }
  demo.return_to(demo.trade_off.trials()[1]);
  CHECK(demo.session.settings().response == Response::penalty);
  CHECK(demo.session.settings().substeps == 10);  // the scene's
  CHECK(demo.trade_off.current() == 1);
  demo.load("cradle");
  CHECK(demo.trade_off.trials().size() == 1);
}

TEST_CASE("a way back through time is no trial") {
  Demo demo("stack", {});
  for (int k = 0; k < 30; ++k) demo.step();
  demo.report();
  const int64_t before = demo.trade_off.trials().at(0).steps;
  demo.go_to(5);
  demo.report();
  CHECK(demo.trade_off.trials().at(0).steps == before);
}
