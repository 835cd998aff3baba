// SPDX-License-Identifier: MIT
// Methods fail where their formulas predict.
#include "lab/experiments/stability.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "lab/report/experiment.h"
#include "measure/theory.h"

using namespace ballpit;

namespace {

Lab quick_lab() {
  LabOptions options;
  options.is_quick = true;
  return Lab(options);
}

}  // namespace

TEST_CASE("the measured boundary of every map lies within one cell of the formula's line, and not of four times it") {
  Lab lab = quick_lab();
  REQUIRE(failure_maps().size() == 6);
  for (FailureMap which : failure_maps()) {
    const Map map = measure_map(lab, which);
    const MapBoundary boundary = boundary_of(which, map);
    INFO(which.name << ": " << boundary.distance << " cells, " << boundary.columns << " columns cross");
    CHECK(boundary.distance <= 1);
    CHECK(boundary.columns >= 8);
    static double (*formula)(double);
    formula = which.theory;
    which.theory = [](double x) { return formula(x) / 4; };
    CHECK(boundary_of(which, map).distance > 1);
  }
}

TEST_CASE("experiments make as many measurements as they announce") {
  for (const char* const name : {"stability", "cooling"}) {
    Lab lab = quick_lab();
    const Experiment& experiment = find_experiment(name);
    const Findings findings = experiment.run(lab);
    CHECK(lab.asked() == experiment.measurements(true));
    CHECK_FALSE(findings.charts.empty());
  }
}

TEST_CASE("linked cells of half a diameter find 0.29 of the contacts, those of a diameter all") {
  constexpr int kPairs = 20000;
  const double error = std::sqrt(0.29 * 0.71 / kPairs);
  CHECK(std::fabs(recall_of_cells(0.5, kPairs, 1) - cell_recall(0.5)) < 4 * error);
  CHECK(recall_of_cells(1.0, kPairs, 1) == 1);
}

TEST_CASE("contacts at the end of a step see the part of hits of the formula, and swept ones all") {
  for (const double step : {1.0, 3.0}) {
    for (const double impact : {0.2, 0.8}) {
      INFO("step " << step << ", impact parameter " << impact);
      CHECK(part_of_hits_seen(step, impact, 500) == Approx(part_seen(step, impact)).margin(0.004));
      CHECK(part_of_hits_seen(step, impact, 50, true) == 1);
    }
  }
}

TEST_CASE("a bullet passes through a thin wall at the end of a step, and not by swept contacts") {
  CHECK(passes_through(0.42, false));
  CHECK_FALSE(passes_through(0.42, true));
  CHECK_FALSE(passes_through(0.1, false));
}
