// SPDX-License-Identifier: MIT
// The pressure of a gas of hard spheres: exact motion against the literature, and the error of a fixed step.

#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"
#include "measure/theory.h"

namespace ballpit {

namespace {

constexpr double kDense = 0.5;  // density of the gas with fixed steps

std::vector<double> densities(bool is_quick) { return spaced(0.1, 0.9, is_quick ? 9 : 17, Scale::linear); }

std::vector<double> steps(bool is_quick) {
  return is_quick ? std::vector<double>{0.005, 0.01, 0.02, 0.04} : std::vector<double>{0.0025, 0.005, 0.01, 0.02, 0.04};
}

GasRun exact_run(const Lab& lab, double rho) { return {5, rho, lab.seed(), lab.is_quick() ? 60 : 500, 40}; }

GasRun stepped_run(const Lab& lab) { return {4, kDense, lab.seed(), lab.is_quick() ? 60 : 400, 15}; }

std::string key_of_run(const std::string& name, const GasRun& run, double dt) {
  return key_of(name, dt, run.cells, run.rho, run.seed, run.blocks, run.collisions);
}

Mean exact_z(Lab& lab, double rho) {
  const GasRun run = exact_run(lab, rho);
  return mean_of(lab.measure(key_of_run("exact", run, 0), [&] { return block_z(run, exact_motion(1)); }));
}

Mean stepped_z(Lab& lab, double dt, bool is_swept) {
  const GasRun run = stepped_run(lab);
  const std::string key = key_of_run(is_swept ? "swept" : "discrete", run, dt);
  return mean_of(lab.measure(key, [&] { return block_z(run, elastic_impulses(dt, is_swept)); }));
}

struct ExactPoint {
  double rho, expected;
  Mean z;
  double errors_off() const { return (z.value - expected) / z.error; }
};

Table table_of(const std::vector<ExactPoint>& points) {
  Table table{"z",
              {"density", "Z measured", "standard error", "Z expected of so many spheres", "Z of Carnahan and Starling",
               "off [standard errors]"},
              {},
              true};
  for (const ExactPoint& p : points) {
    table.add_row(p.rho, p.z.value, p.z.error, p.expected, carnahan_starling_z(p.rho), p.errors_off());
  }
  return table;
}

std::vector<Chart> charts_of(const std::vector<ExactPoint>& points) {
  const Axis density{"density N·D³/V"};
  const std::vector<double> xs = spaced(points.front().rho, points.back().rho, 100, Scale::linear);
  const auto percent = [](double z, double rho) { return 100 * (z / reference_z(rho) - 1); };
  const auto deviation = [&](const ExactPoint& p) {
    const double z = p.z.value + (reference_z(p.rho) - p.expected);  // without the effect of the number of spheres
    return Point{p.rho, percent(z, p.rho), percent(z - p.z.error, p.rho), percent(z + p.z.error, p.rho)};
  };
  Chart whole{"z", "The pressure of hard spheres, over that of an ideal gas", density, {"Z = PV/NkT"}};
  whole.series = {theory_line("reference", xs, reference_z),
                  make_series("event-driven", "first", Stroke::points, points,
                              [](const ExactPoint& p) { return point_of(p.rho, p.z); })};
  Chart detail{"deviation", "How far the pressure is from the reference", density, {"deviation of Z", "%"}};
  detail.series = {
      theory_line("Carnahan–Starling", xs, [&](double rho) { return percent(carnahan_starling_z(rho), rho); }),
      theory_line("reference", xs, [](double) { return 0.0; }),
      make_series("event-driven", "first", Stroke::points, points, deviation)};
  return {whole, detail};
}

/// Z − Z_N of gases with a fixed step.
struct SteppedPoint {
  double dt;
  Mean discrete, swept;
  double expected;  ///< of late contacts
};

Table table_of(const std::vector<SteppedPoint>& points) {
  Table table{
      "late-contacts",
      {"step", "bias measured", "standard error", "bias expected", "bias of swept contacts", "its standard error"},
      {},
      true};
  for (const SteppedPoint& p : points) {
    table.add_row(p.dt, p.discrete.value, p.discrete.error, p.expected, p.swept.value, p.swept.error);
  }
  return table;
}

Chart chart_of(const std::vector<SteppedPoint>& points, double count) {
  const auto bias = [count](double dt) { return late_contact_z(kDense, count, dt) - finite_z(kDense, count); };
  const auto measured = [&](const char* label, const char* role, Mean SteppedPoint::*z) {
    return make_series(label, role, Stroke::points, points,
                       [z](const SteppedPoint& p) { return point_of(p.dt, p.*z); });
  };
  return {"late-contacts",
          "A fixed step sees each hit late, and the pressure falls",
          {"step dt", "D/√(kT/m)"},
          {"Z − exact Z"},
          {theory_line("late by dt/2", spaced(0, points.back().dt, 50, Scale::linear), bias),
           measured("discrete", "first", &SteppedPoint::discrete), measured("swept", "second", &SteppedPoint::swept)}};
}

int64_t measurements(bool is_quick) {
  return static_cast<int64_t>(densities(is_quick).size() + 2 * steps(is_quick).size());
}

Findings measure(Lab& lab) {
  std::vector<ExactPoint> exact;
  double squares = 0, error = 0;
  for (const double rho : densities(lab.is_quick())) {
    exact.push_back({rho, finite_z(rho, count_of(exact_run(lab, rho))), exact_z(lab, rho)});
    squares += exact.back().errors_off() * exact.back().errors_off() / double(densities(lab.is_quick()).size());
    error = std::max(error, exact.back().z.error / exact.back().z.value);
  }
  std::vector<SteppedPoint> stepped;
  const double count = count_of(stepped_run(lab)), truth = finite_z(kDense, count);
  for (const double dt : steps(lab.is_quick())) {
    Mean discrete = stepped_z(lab, dt, false), swept = stepped_z(lab, dt, true);
    discrete.value -= truth;
    swept.value -= truth;
    stepped.push_back({dt, discrete, swept, late_contact_z(kDense, count, dt) - truth});
  }
  const SteppedPoint& coarse = stepped.back();
  Findings findings{{table_of(exact), table_of(stepped)},
                    charts_of(exact),
                    {{"error", three_digits(100 * error)},
                     {"off", three_digits(std::sqrt(squares))},
                     {"step", three_digits(coarse.dt)},
                     {"bias", three_digits(-100 * coarse.discrete.value / truth)},
                     {"expected", three_digits(-100 * coarse.expected / truth)}}};
  findings.charts.push_back(chart_of(stepped, count));
  return findings;
}

}  // namespace

double count_of(const GasRun& run) { return 4.0 * run.cells * run.cells * run.cells; }

std::vector<double> block_z(const GasRun& run, const Settings& settings) {
  return block_z(run, settings, equilibrium_gas(run.cells, run.rho, run.seed));
}

std::vector<double> block_z(const GasRun& run, const Settings& settings, const Scene& gas) {
  const double count = count_of(run), block = run.collisions / collision_rate(run.rho, count);
  Settings own = settings;
  own.keeps_tally = true;
  if (settings.response == Response::event_driven) own.dt = block;
  Scene scene = gas;
  std::vector<double> values;
  for (int k = 0; k < run.blocks; ++k) {
    const auto world = make_world_on_cpu(scene, own);
    const double before = world->report().kinetic_energy;
    step_until(*world, block, own.dt);
    const Report now = world->report();
    const double kt = (before + now.kinetic_energy) / (3 * (count - 1));
    values.push_back(1 + now.tally.virial / (3 * count * kt * now.time));
    scene.bodies = world->bodies();
    for (Vec3d& v : scene.bodies.velocity) v *= std::sqrt(1.5 * (count - 1) / now.kinetic_energy);
  }
  return values;
}

Settings elastic_impulses(double dt, bool is_swept) {
  Settings settings = settings_of("impulse", dt);
  settings.solver = Solver::gauss_seidel;
  settings.correction = Correction::none;
  settings.is_swept = is_swept;
  return settings;
}

Experiment equation_of_state_experiment() { return {"equation-of-state", 25, 300, measurements, measure}; }

}  // namespace ballpit
