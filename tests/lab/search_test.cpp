// SPDX-License-Identifier: MIT
// The counted results of experiments on searches, which are equal on every machine.
#include <cmath>
#include <map>
#include <memory>

#include <catch2/catch.hpp>

#include "lab/experiments/experiments.h"
#include "lab/experiments/winner_map.h"
#include "lab/measure/searches.h"
#include "measure/exact_pairs.h"
#include "measure/statistics.h"
#include "world/world.h"

using namespace ballpit;

namespace {

double candidates(const Settings& settings, const SphereSet& spheres) {
  const std::unique_ptr<PairSearch> search = cpu_backend().make_pair_search(settings);
  search->find(spheres.arrays());
  return static_cast<double>(search->report().candidates);
}

/// The share of the contacts that a grid with cells of this size finds.
double recall(const std::string& grid, double cell_size, const SphereSet& spheres, const std::vector<Pair>& contacts) {
  Settings settings = search_by(grid);
  settings.cell_size = cell_size;
  const std::unique_ptr<PairSearch> search = cpu_backend().make_pair_search(settings);
  search->find(spheres.arrays());
  const Deviation deviation = deviation_of(search->pairs(), contacts);
  CHECK(deviation.wrong == 0);
  CHECK(deviation.duplicate == 0);
  return 1 - static_cast<double>(deviation.missed) / static_cast<double>(contacts.size());
}

SearchTiming timing_of(std::vector<double> seconds) { return {std::move(seconds)}; }

}  // namespace

TEST_CASE("a fit recovers a power law, and scatter gives a standard error") {
  const PowerFit exact = fit_power({1, 10, 100}, {3, 3 * std::pow(10, 1.5), 3000});
  CHECK(exact.exponent == Approx(1.5));
  CHECK(exact.factor == Approx(3));
  CHECK(exact.error < 1e-9);
  // By hand: log y/log 10 = 0, 1.3, 2 at log x/log 10 = 0, 1, 2: slope 1, residuals −.1, .2, −.1, error √(.06/1/2).
  const PowerFit rough = fit_power({1, 10, 100}, {1, std::pow(10, 1.3), 100});
  CHECK(rough.exponent == Approx(1));
  CHECK(rough.error == Approx(std::sqrt(0.03)));
}

TEST_CASE("candidates grow as theory says: n², n^(5/3), n, n") {
  const std::map<std::string, double> expected{
      {"brute-force", 2}, {"sort-and-sweep", 5.0 / 3}, {"linked-cell", 1}, {"sorted-grid", 1}};
  for (const std::string& name : broad_phases()) {
    std::vector<double> x, y;
    for (const int64_t count : {1000, 3000, 10'000, 30'000}) {
      x.push_back(static_cast<double>(count));
      y.push_back(candidates(search_by(name), uniform_spheres({count}, 1)));
    }
    INFO(name);
    REQUIRE(expected.count(name) == 1);
    CHECK(std::fabs(fit_power(x, y).exponent - expected.at(name)) < 0.15);
  }
}

TEST_CASE("small cells find the share of contacts of the formula, within its error") {
  const SphereSet spheres = touching_pairs(20'000, 7);
  const std::vector<Pair> contacts = exact_pairs(spheres.arrays());
  REQUIRE(contacts.size() == 10'000);
  for (const char* grid : {"linked-cell", "sorted-grid"}) {
    for (const double size : {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95}) {
      INFO(grid << ", cells of " << size);
      const double expected = expected_recall(spheres, contacts, size);
      CHECK(std::fabs(recall(grid, size, spheres, contacts) - expected) < 4 * recall_error(expected, contacts.size()));
    }
    for (const double size : {1.0, 1.1, 2.0, 5.0}) CHECK(recall(grid, size, spheres, contacts) == 1);
  }
}

TEST_CASE("cells with the least edge of slide 7, half of what the block needs, miss seven contacts in ten") {
  const SphereSet spheres = touching_pairs(20'000, 3);
  const std::vector<Pair> contacts = exact_pairs(spheres.arrays());
  // 0.2905: the formula's mean over all directions. 0.01: two standard errors of 10 000 pairs.
  CHECK(expected_recall(spheres, contacts, 0.5) == Approx(0.2905).margin(0.01));
  CHECK(recall("linked-cell", 0.5, spheres, contacts) == Approx(0.2905).margin(0.01));
  CHECK(expected_recall(spheres, contacts, 1) == 1);
}

TEST_CASE("intervals overlap as often as expected, on the long side of a box and on the short one") {
  for (const double aspect : {0.1, 1.0, 10.0}) {
    const UniformSpheres wanted{10'000, 0.3, 1, aspect};
    const SphereSet spheres = uniform_spheres(wanted, 5);
    for (const char* axis : {"x", "y", "z"}) {
      Settings settings = search_by("sort-and-sweep");
      settings.axis = named<SweepAxis>(axis);
      const double length = axis[0] == 'z' ? box_of(wanted).z : box_of(wanted).x;
      INFO("aspect " << aspect << ", axis " << axis);
      CHECK(candidates(settings, spheres) == Approx(expected_interval_overlaps(10'000, length)).epsilon(0.02));
    }
  }
  CHECK(expected_interval_overlaps(10, 0.5) == 45);
}

TEST_CASE("in one grid candidates grow with the size ratio, in a grid for each size class they do not") {
  const auto growth = [](const char* method) {
    const double small = candidates(search_by(method), uniform_spheres({20'000, 0.3, 2}, 1));
    return candidates(search_by(method), uniform_spheres({20'000, 0.3, 16}, 1)) / small;
  };
  CHECK(growth("linked-cell") > 20);  // between q² and q³, q = 8 from one to the other
  CHECK(growth("sorted-grid") < 2);
}

TEST_CASE("uniform spheres fill the requested share of their box") {
  for (const double ratio : {1.0, 4.0, 32.0}) {
    const UniformSpheres wanted{100'000, 0.2, ratio, 3};
    const SphereSet spheres = uniform_spheres(wanted, 2);
    double volume = 0;
    for (int64_t i = 0; i < wanted.count; ++i) {
      const double r = spheres.radius[spheres.radius.size() == 1 ? 0 : static_cast<size_t>(i)];
      volume += 4.0 / 3 * 3.14159265358979 * r * r * r;
    }
    const Vec3d box = box_of(wanted);
    CHECK(box.z == Approx(3 * box.x));
    CHECK(volume / (box.x * box.y * box.z) == Approx(0.2).epsilon(0.05));
  }
}

TEST_CASE("a method that loses more than one turn in nine is not the winner") {
  CHECK(winner_among({timing_of({2, 2, 2}), timing_of({1, 1, 1})}) == 1);
  CHECK(winner_among({timing_of({1, 1.1, 1.2}), timing_of({1.1, 1.05, 1.3})}) == kTie);
  CHECK(winner_among({timing_of({1, 1, 1}), SearchTiming{}, timing_of({3, 3, 3})}) == 0);
  CHECK(winner_among({SearchTiming{}, timing_of({3, 3, 3})}) == 1);
}

TEST_CASE("the largest step is the coarser of two in a row within the tolerance") {
  const auto error = [](double dt, double off) { return PressureError{dt, {off, 0}}; };
  CHECK(largest_step({error(4, kNoNumber), error(2, 0.03), error(1, 0.019), error(0.5, -0.01)}) == 1);
  CHECK(largest_step({error(4, 0.001), error(2, 0.03), error(1, 0.01)}) ==
        0);  // by chance: the next step does not confirm it
  CHECK(largest_step({}) == 0);
}
