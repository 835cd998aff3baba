// SPDX-License-Identifier: MIT
// Galperin's billiard: a light ball between a wall and a heavy one collides ⌊π·√R⌋ times with both together, at the
// mass ratio R = 100^k (2003, Regular and Chaotic Dynamics 8, 375). Where does a response with steps begin to miscount?
//
//     │ ○        ◂── ⬤      the heavy ball, at 1 m/s, turns where the gap is 1/√R of the one at which it met the light
//                            ball; there the light one has √R m/s: hits follow each other within gap/R seconds
//
// The velocities depend only on the order of hits, not on when they come. So a response that resolves one hit after the
// other counts right although it is late, until the light ball leaves through the wall: it has √R m/s, so a step must
// be at most radius/√R. A response that resolves both hits of a step at once, or misses one, needs gap/R.
#include <numbers>

#include "lab/experiments/contact_methods.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"

namespace ballpit {

namespace {

constexpr double kGap = 0.4;       // [m] between the light ball and the wall, when it is struck
constexpr double kRadius = 0.1;    // [m] of the light ball
constexpr double kDuration = 3.5;  // [s] by then both balls fly away
constexpr double kCoarsest = 0.1;  // [s]

/// The methods of this experiment: the main ones of all responses with steps, and swept impulses.
std::vector<ContactMethod> counted_methods() {
  std::vector<ContactMethod> methods;
  for (ContactMethod method : contact_methods()) {
    if (method.name == "impulse, swept") method.label = method.name;
    if (has_steps(method) && (method.is_main || method.name == "impulse, swept")) methods.push_back(method);
  }
  return methods;
}

/// Not 1 or 3, where π/atan(√(1/R)) is an integer and rounding decides about the last collision.
std::vector<double> ratios(bool is_quick) {
  return is_quick ? std::vector<double>{10, 100} : std::vector<double>{10, 100, 1e3, 1e4};
}

/// The ratios of which the report shows the counts.
std::vector<double> shown_ratios(bool is_quick) {
  return is_quick ? std::vector<double>{100} : std::vector<double>{100, 1e4};
}

/// From fine to coarse, two in each octave. Contacts of springs last 20 steps, so they need finer ones.
std::vector<double> steps_for(const ContactMethod& method, double ratio) {
  const double finest = safe_step(ratio) / (method.settings.response == Response::penalty ? 16 : 4);
  std::vector<double> steps;
  for (int k = 0; steps.empty() || steps.back() > finest; ++k) steps.push_back(kCoarsest * std::exp2(-k / 2.0));
  std::ranges::reverse(steps);
  return steps;
}

/// A method at a mass ratio: the number of collisions at each step, infinite if the run stops.
struct Counts {
  ContactMethod method;
  double ratio;
  std::vector<double> steps, counted;

  /// The coarsest step from which on all finer ones count right within a percent; kNoNumber if there is none.
  double largest_right() const {
    const double exact = exact_collisions(ratio);
    double largest = kNoNumber;
    for (size_t k = 0; k < steps.size() && std::fabs(counted[k] - exact) <= 0.01 * exact; ++k) largest = steps[k];
    return largest;
  }
};

std::vector<Counts> count_all(Lab& lab) {
  std::vector<Counts> all;
  for (const ContactMethod& method : counted_methods()) {
    for (const double ratio : ratios(lab.is_quick())) {
      Counts counts{method, ratio, steps_for(method, ratio), {}};
      const auto key = key_of("collisions", method.name, ratio, counts.steps.size(), counts.steps.front());
      counts.counted = lab.measure(key, [&] {
        std::vector<double> values;
        for (const double dt : counts.steps) values.push_back(collisions_counted(with_step(method, dt), ratio));
        return values;
      });
      all.push_back(std::move(counts));
    }
  }
  return all;
}

int64_t measurements(bool is_quick) { return static_cast<int64_t>(counted_methods().size() * ratios(is_quick).size()); }

Chart count_chart(const std::vector<Counts>& all, double ratio) {
  const double exact = exact_collisions(ratio);
  const std::string digits = fmt::format("{:.0f}", exact);
  Chart chart{"count-" + digits, phrase("Mass ratio {}: {} collisions", grouped(std::llround(ratio)), digits),
              Axis{"step dt", "s", Scale::log}, Axis{"collisions counted", "", Scale::log, 0.8, 10 * exact}};
  double finest = kCoarsest;
  for (const Counts& counts : all) {
    if (counts.ratio != ratio) continue;
    Series series = series_of(counts.method);
    for (size_t k = 0; k < counts.steps.size(); ++k) {
      series.points.push_back({counts.steps[k], counts.counted[k]});
      if (std::isinf(counts.counted[k])) break;  // one cross for each method
    }
    finest = std::min(finest, counts.steps.front());
    chart.series.push_back(series);
  }
  chart.series.insert(chart.series.begin(),
                      theory_line(phrase("exact: {}", digits), {finest, kCoarsest}, [&](double) { return exact; }));
  return chart;
}

Chart step_chart(const std::vector<Counts>& all, const std::vector<double>& at) {
  Chart chart{"step", "The largest step that counts right falls as the mass ratio grows",
              Axis{"mass ratio R", "", Scale::log}, Axis{"largest step that counts right", "s", Scale::log}};
  chart.series.push_back(theory_line(translated("gap/R"), at, safe_step));
  chart.series.push_back(theory_line(translated("radius/√R"), at, leaving_step));
  for (const ContactMethod& method : counted_methods()) {
    Series series = series_of(method);
    for (const Counts& counts : all) {
      if (counts.method.name != method.name || !(counts.largest_right() > 0)) continue;
      series.points.push_back({counts.ratio, counts.largest_right()});
    }
    if (!series.points.empty()) chart.series.push_back(series);
  }
  return chart;
}

Table table_of(const std::vector<Counts>& all) {
  Table table{"counts", {"method", "mass ratio", "step [s]", "collisions counted", "exact"}};
  for (const Counts& counts : all) {
    for (size_t k = 0; k < counts.steps.size(); ++k) {
      table.add_row(counts.method.name, counts.ratio, counts.steps[k], counts.counted[k],
                    exact_collisions(counts.ratio));
    }
  }
  return table;
}

Table summary_of(const std::vector<Counts>& all) {
  Table table{"steps", {"method", "mass ratio", "exact", "largest step that counts right [s]", "in units of gap/R"}};
  for (const Counts& counts : all) {
    const double largest = counts.largest_right();
    table.add_row(counts.method.name, counts.ratio, exact_collisions(counts.ratio), largest,
                  largest / safe_step(counts.ratio));
  }
  return table;
}

Findings measure(Lab& lab) {
  const std::vector<Counts> all = count_all(lab);
  const double highest = ratios(lab.is_quick()).back();
  const auto of = [&](std::string_view name) {
    const auto found = std::ranges::find_if(
        all, [&](const Counts& counts) { return counts.method.name == name && counts.ratio == highest; });
    const double largest = found->largest_right();
    return std::isnan(largest) ? translated("no step") : short_text(largest) + " s";
  };
  Findings findings{{summary_of(all), table_of(all)},
                    {},
                    {{"ratio", grouped(std::llround(highest))},
                     {"exact", number_text(exact_collisions(highest))},
                     {"impulse", of("impulse")},
                     {"positions", of("position-based")},
                     {"springs", of("penalty, velocity-verlet")},
                     {"gap", number_text(kGap)},
                     {"radius", number_text(kRadius)}}};
  for (const double ratio : shown_ratios(lab.is_quick())) findings.charts.push_back(count_chart(all, ratio));
  findings.charts.push_back(step_chart(all, ratios(lab.is_quick())));
  return findings;
}

}  // namespace

double exact_collisions(double ratio) {
  return std::ceil(std::numbers::pi / std::atan(1 / std::sqrt(ratio)) * (1 - 1e-12)) - 1;
}

double safe_step(double ratio) { return kGap / ratio; }
double leaving_step(double ratio) { return kRadius / std::sqrt(ratio); }

double collisions_counted(Settings settings, double ratio) {
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(5, 1, 0), Boundary::walls, 2};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  scene.physics.stiffness = stiffness_for(settings.dt, kStepsOfContact, ratio / (1 + ratio), 1);
  put_sphere(scene, {kGap + kRadius, 0.5, 0}, Vec3d(0.0), kRadius, 1);
  put_sphere(scene, {kGap + 5 * kRadius + 0.0123, 0.5, 0}, {-1, 0, 0}, 3 * kRadius, ratio);  // they meet after 0.0123 s
  settings.broadphase = BroadPhase::brute_force;
  settings.keeps_tally = true;
  settings.max_overlap = 1e6;  // failures are to be seen
  settings.max_energy = 1e15;
  TimedRun run(scene, settings);
  if (!run.reach(kDuration)) return INFINITY;
  const Tally tally = run.world().report().tally;
  return static_cast<double>(tally.collisions + tally.wall_hits);
}

Experiment pi_experiment() { return {"pi", 2, 60, measurements, measure}; }

}  // namespace ballpit
