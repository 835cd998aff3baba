// SPDX-License-Identifier: MIT
// How evenly a search distributes its work over threads, and how busy that keeps a GPU, whose threads run in lockstep.
// The walks of slide 4 differ in length; the lists of slides 12 to 15 differ as cells do.

#include "lab/experiments/experiments.h"
#include "lab/measure/searches.h"
#include "measure/statistics.h"
#include "world/world.h"

namespace ballpit {

namespace {

struct Arrangement {
  const char* name;
  SphereSet (*make)(int64_t count, uint64_t seed);
};

SphereSet uniform(int64_t count, uint64_t seed) { return uniform_spheres({count}, seed); }
SphereSet uneven(int64_t count, uint64_t seed) { return uniform_spheres({count, 0.3, 10}, seed); }

constexpr Arrangement kArrangements[] = {{"uniform", uniform}, {"radii 1:10", uneven}, {"clouds", clouds}};

/// Work has bins 0, 1, 2 to 3, 4 to 7, …; these hold all that an index can count.
constexpr size_t kBins = 33;

/// Threads, mean, most, SIMD efficiency, and the threads of each bin.
std::vector<double> profile(const std::string& broadphase, const SphereSet& spheres) {
  const auto search = cpu_backend().make_pair_search(search_by(broadphase));
  search->find(spheres.arrays());
  const WorkProfile work = profile_work(search->work_per_thread());
  std::vector<double> values{static_cast<double>(work.threads), work.mean, static_cast<double>(work.most),
                             work.simd_efficiency.value_or(kNoNumber)};
  for (const WorkBin& bin : work.bins) values.push_back(static_cast<double>(bin.threads));
  values.resize(4 + kBins, 0);
  return values;
}

int64_t count_of(bool is_quick) { return is_quick ? 10'000 : 100'000; }

int64_t measurements(bool) { return static_cast<int64_t>(std::size(kArrangements) * broad_phases().size()); }

/// The share of the threads by their work, at the middle of each bin; no work is drawn at a half.
Series histogram(const std::string& broadphase, const std::vector<double>& values) {
  Series series{label_of(broadphase), broadphase};
  const auto end = static_cast<size_t>(std::log2(std::max(1.0, values[2]))) + 2;  // after the bin of the most work
  for (size_t bin = 0; bin < end; ++bin) {
    const double low = std::exp2(static_cast<double>(bin) - 1);
    series.points.push_back({bin < 2 ? low : 1.5 * low - 0.5, 100 * values[4 + bin] / values[0]});
  }
  return series;
}

Findings measure(Lab& lab) {
  const int64_t count = count_of(lab.is_quick());
  Table table{
      "work", {"arrangement", "broad phase", "threads", "mean work", "most work", "SIMD efficiency [%]"}, {}, true};
  Chart chart{"work",
              phrase("Threads by their work, {} equal spheres", grouped(count)),
              Axis{"work of a thread: candidates", "", Scale::log},
              {"share of the threads", "%"}};
  double least = 1, most = 0;
  std::string worst, best;
  for (const Arrangement& arrangement : kArrangements) {
    for (const std::string& name : broad_phases()) {
      const std::string key =
          fmt::format("tests of each thread; {}; {}; {} spheres; seed {}", arrangement.name, name, count, lab.seed());
      const std::vector<double> values =
          lab.measure(key, [&] { return profile(name, arrangement.make(count, lab.seed())); });
      table.add_row(arrangement.name, label_of(name), values[0], values[1], values[2], 100 * values[3]);
      if (values[3] < least)
        least = values[3], worst = phrase("{} among {}", translated(label_of(name)), translated(arrangement.name));
      if (&arrangement != kArrangements || name == "brute-force") continue;
      chart.series.push_back(histogram(name, values));
      if (values[3] > most) most = values[3], best = translated(label_of(name));
    }
  }
  return {{table},
          {chart},
          {{"best", best}, {"most", three_digits(100 * most)}, {"worst", worst}, {"least", three_digits(100 * least)}}};
}

}  // namespace

Experiment divergence_experiment() { return {"divergence", 2, 60, measurements, measure}; }

}  // namespace ballpit
