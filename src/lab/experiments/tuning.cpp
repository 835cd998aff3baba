// SPDX-License-Identifier: MIT
// What tuning gains: the slides' own kernels against the methods that are made of them, on the same spheres.

#include "lab/experiments/experiments.h"

namespace ballpit {

namespace {

struct Kernel {
  const char *name, *role;
  bool is_slides;  ///< the kernel of the slides; the one after it is tuned
};

constexpr Kernel kKernels[] = {{"lecture/sort-and-sweep", "sort-and-sweep", true},
                               {"sort-and-sweep", "sort-and-sweep", false},
                               {"lecture/linked-cell", "linked-cell", true},
                               {"linked-cell", "linked-cell", false},
                               {"sorted-grid", "sorted-grid", false}};

std::vector<double> counts(bool is_quick) {
  if (is_quick) return {100, 1000, 10'000};
  return {100, 300, 1000, 3000, 10'000, 30'000, 100'000};
}

int64_t measurements(bool is_quick) { return kSearchRounds * static_cast<int64_t>(counts(is_quick).size()); }

Findings measure(Lab& lab) {
  std::vector<SearchCase> cases;
  for (const double count : counts(lab.is_quick())) {
    const auto spheres = static_cast<int64_t>(count);
    SearchCase wanted{fmt::format("ms a search by the slides' kernels; {} spheres; seed {}", spheres, lab.seed()),
                      {},
                      [spheres, seed = lab.seed()] { return uniform_spheres({spheres}, seed); }};
    for (const Kernel& kernel : kKernels) wanted.methods.push_back(search_by(kernel.name));
    cases.push_back(std::move(wanted));
  }
  const std::vector<std::vector<SearchTiming>> timings = time_searches(lab, cases);

  Table table{"searches",
              {"broad phase", "spheres", "time [ms]", "lower quartile [ms]", "upper quartile [ms]", "candidates"}};
  Chart chart{"time", "Time of a search on one thread: slides' kernels and tuned ones", Axis{"spheres", "", Scale::log},
              Axis{"time of a search", "ms", Scale::log}};
  std::vector<double> last;  // [s] of each kernel with the most spheres
  for (size_t k = 0; k < std::size(kKernels); ++k) {
    const Kernel& kernel = kKernels[k];
    Series series{label_of(kernel.name), kernel.role};
    series.is_dashed = kernel.is_slides;
    for (size_t n = 0; n < cases.size(); ++n) {
      const double count = counts(lab.is_quick())[n];
      const Point point = point_of(count, timings[n][k].spread(), 1e3);
      series.points.push_back(point);
      table.add_row(kernel.name, count, point.y, point.low, point.high, timings[n][k].candidates);
    }
    last.push_back(series.points.back().y);
    chart.series.push_back(std::move(series));
  }
  return {{table},
          {chart},
          {{"spheres", grouped(static_cast<int64_t>(counts(lab.is_quick()).back()))},
           {"sweep", three_digits(last[0] / last[1])},
           {"lists", three_digits(last[2] / last[3])},
           {"grid", three_digits(last[2] / last[4])}}};
}

}  // namespace

Experiment tuning_experiment() { return {"tuning", 10, 120, measurements, measure}; }

}  // namespace ballpit
