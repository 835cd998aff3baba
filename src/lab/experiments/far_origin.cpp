// SPDX-License-Identifier: MIT
// A stack and a heap far from the origin, as in the samples "Far" of solver2d (Catto,
// https://github.com/erincatto/solver2d), which are up to (900 km, −800 km) away. The map far-out of `stability` shows
// one sphere in flight; here spheres fall and press on each other, and the question is which response survives the
// rounding of positions, and how far out.
//
//     ○     ○  ○  ○       spheres a quarter of a diameter apart fall onto each other
//     ○      ○  ○  ○      in a box whose lower left corner is at (x, −0.8·x)
//     ○     ○  ○  ○
//
// A stack has one height at rest. A heap has many, since rounding decides which way a sphere rolls; so of the heap only
// the overlap is compared.
#include "lab/experiments/contact_methods.h"
#include "lab/experiments/experiments.h"
#include "lab/measure/made_scenes.h"
#include "measure/theory.h"

namespace ballpit {

namespace {

constexpr double kRadius = 0.1;  // [m]
constexpr int kSide = 10;        // spheres in a row, and rows
constexpr double kWide = 1.25;   // [diameters] from centre to centre at the start
constexpr double kSettled = 3;   // [s]
constexpr double kDown = 0.8;    // y of the corner is −kDown times its x

/// The methods that carry a heap at the origin: the main ones of all responses but the kinematic one, and the same in
/// single precision; impulses by enough sweeps. Exact motion would need millions of events.
std::vector<ContactMethod> heap_methods() {
  std::vector<ContactMethod> methods;
  for (ContactMethod method : contact_methods()) {
    const Response response = method.settings.response;
    if (!has_steps(method) || response == Response::kinematic) continue;
    if (!method.is_main && !is_float_of_main(method)) continue;
    method.settings.dt = response == Response::penalty ? 1.0 / 2400 : 1.0 / 240;  // soft springs carry no heap
    if (response == Response::impulse) {
      method.settings.solver = Solver::gauss_seidel;
      method.settings.iterations = 16;
    }
    methods.push_back(method);
  }
  return methods;
}

std::vector<double> distances(bool is_quick) { return spaced(1, 1e6, is_quick ? 7 : 13, Scale::log); }

/// A method, and the heaps at each of the distances.
struct Course {
  ContactMethod method;
  std::vector<FarHeaps> heaps;

  /// The greatest of the distances up to which none fails.
  double reach(const std::vector<double>& at) const {
    double last = kNoNumber;
    for (size_t k = 0; k < at.size() && !heaps[k].fails(); ++k) last = at[k];
    return last;
  }
};

std::vector<Course> measure_all(Lab& lab, const std::vector<double>& at) {
  std::vector<Course> courses;
  for (const ContactMethod& method : heap_methods()) {
    Course course{method, {}};
    const Settings& settings = method.settings;
    for (const double x : at) {
      const auto key = key_of("heaps", method.name, settings.dt, iterations_of(settings), x, kSide, kSettled);
      const auto values = lab.measure(key, [&] {
        const FarHeaps heaps = heaps_at(x, settings);
        return std::vector<double>{heaps.height_error, heaps.overlap};
      });
      course.heaps.push_back({values[0], values[1]});
    }
    courses.push_back(std::move(course));
  }
  return courses;
}

Chart chart_of(const std::vector<Course>& courses, const std::vector<double>& at, const std::string& name,
               const std::string& title, const Axis& y, double FarHeaps::*what) {
  Chart chart{name, title, Axis{"distance x from the origin", "m", Scale::log}, y};
  chart.series.push_back(theory_line("ulp(x)/2", at, [](double x) { return frozen_step(x) / kRadius; }));
  for (const Course& course : courses) {
    Series series = series_of(course.method);
    series.is_thin = false;
    if (series.is_dashed) series.label = std::string(name_of(course.method.settings.response)) + ", float";
    for (size_t k = 0; k < at.size(); ++k) {
      series.points.push_back({at[k], std::max(2 * *y.low, course.heaps[k].*what)});
      if (std::isinf(course.heaps[k].*what)) break;  // one cross for each failed run
    }
    chart.series.push_back(series);
  }
  return chart;
}

Table table_of(const std::vector<Course>& courses, const std::vector<double>& at) {
  Table table{"heaps", {"method", "distance [m]", "error of height / radius", "largest overlap / radius"}};
  for (const Course& course : courses) {
    for (size_t k = 0; k < at.size(); ++k) {
      table.add_row(course.method.name, at[k], course.heaps[k].height_error, course.heaps[k].overlap);
    }
  }
  return table;
}

Table reaches_of(const std::vector<Course>& courses, const std::vector<double>& at) {
  Table table{"reach", {"method", "right up to [m]", "ulp(x)/2 there / radius"}};
  for (const Course& course : courses) {
    const double reach = course.reach(at);
    const bool is_float = course.method.settings.precision == Precision::float32;
    table.add_row(course.method.name, reach, is_float ? frozen_step(reach) / kRadius : kNoNumber);
  }
  return table;
}

int64_t measurements(bool is_quick) { return static_cast<int64_t>(heap_methods().size() * distances(is_quick).size()); }

/// "300 m", "30 km".
std::string distance_text(double x) {
  return x < 999 ? short_text(std::round(x)) + " m" : short_text(std::round(x / 100) / 10) + " km";
}

Findings measure(Lab& lab) {
  const std::vector<double> at = distances(lab.is_quick());
  const std::vector<Course> courses = measure_all(lab, at);
  const auto reach = [&](Response response, Precision precision) {
    const auto found = std::ranges::find_if(courses, [&](const Course& c) {
      return c.method.settings.response == response && c.method.settings.precision == precision;
    });
    const double last = found->reach(at);
    return distance_text(std::isnan(last) ? 0 : last);
  };
  double least_double = INFINITY;
  for (const Course& course : courses) {
    if (course.method.settings.precision == Precision::float64) least_double = std::min(least_double, course.reach(at));
  }
  const Axis error{"error of height / radius", "", Scale::log, 5e-7, 10},
      overlap{"largest overlap / radius", "", Scale::log, 1e-3, 10};
  return {{reaches_of(courses, at), table_of(courses, at)},
          {chart_of(courses, at, "stack", "A stack far from the origin: how wrong its height is", error,
                    &FarHeaps::height_error),
           chart_of(courses, at, "heap", "A heap far from the origin: how far its spheres overlap", overlap,
                    &FarHeaps::overlap)},
          {{"impulse", reach(Response::impulse, Precision::float32)},
           {"springs", reach(Response::penalty, Precision::float32)},
           {"positions", reach(Response::position_based, Precision::float32)},
           {"double", distance_text(least_double)}}};
}

/// The height [m] of the centre of mass above the floor.
double height_of(World& world, double floor) {
  double height = 0;
  const Bodies bodies = world.bodies();
  for (const Vec3d& p : bodies.position) height += (p.y - floor) / static_cast<double>(bodies.size());
  return height;
}

/// kSide rows of so many discs: one above the other, or staggered.
Scene far_heap(double x, int in_row, const Settings& settings) {
  const double spacing = 2 * kRadius * kWide, width = kSide * spacing;
  const Vec3d corner(x, -kDown * x, 0);
  Scene scene;
  scene.domain = {corner, corner + Vec3d(width, 2 * width, 0), Boundary::walls, 2};
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 0.2;
  scene.physics.stiffness = stiffness_for(settings.dt, kStepsOfContact, 0.5, 0.2);
  const double apart = (kSide - 1) * spacing / kSide;  // along a row, with room for half of a spacing
  for (int k = 0; k < kSide * in_row; ++k) {
    const int row = k / in_row;
    const double shift = in_row > 1 && row % 2 == 1 ? apart / 2 : 0;
    put_sphere(scene, corner + Vec3d(spacing / 2 + k % in_row * apart + shift, (row + 0.5) * spacing, 0), Vec3d(0.0),
               kRadius, 1);
  }
  return scene;
}

/// The height of the centre of mass after kSettled, and the largest overlap; infinite if the run stops.
std::pair<double, double> settle(double x, int in_row, Settings settings) {
  settings.max_overlap = 1e6;  // failures are to be seen
  settings.max_energy = 1e15;
  TimedRun run(far_heap(x, in_row, settings), settings);
  if (!run.reach(kSettled)) return {INFINITY, INFINITY};
  return {height_of(run.world(), -kDown * x), run.world().report().max_overlap};
}

}  // namespace

FarHeaps heaps_at(double x, const Settings& settings) {
  Settings exact = settings;
  exact.precision = Precision::float64;
  const double expected = settle(0, 1, exact).first;
  return {std::fabs(settle(x, 1, settings).first - expected) / kRadius, settle(x, kSide, settings).second};
}

Experiment far_origin_experiment() { return {"far-origin", 5, 15, measurements, measure}; }

}  // namespace ballpit
