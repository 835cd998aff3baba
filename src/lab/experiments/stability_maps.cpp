// SPDX-License-Identifier: MIT
// The measurements behind the maps of `stability`, and the table of maps.
#include <set>

#include "core/random.h"
#include "lab/experiments/stability.h"
#include "lab/measure/made_scenes.h"
#include "measure/theory.h"
#include "world/pair_search.h"

namespace ballpit {

namespace {

constexpr double kSqueeze = 1e-5;     // [diameters] overlap of neighbours in the crystal at rest
constexpr double kDisturbed = 1e-11;  // [m] displacement, so small that a thousandfold growth breaks no contact
constexpr double kGrown = 1000;

/// An fcc crystal of 3 × 3 × 3 cells in a periodic box, its spheres slightly displaced.
Scene crystal(double stiffness) {
  constexpr int kCells = 3;
  const double edge = (1 - kSqueeze) * std::sqrt(2.0);
  Random random(5);
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(kCells * edge), Boundary::periodic, 3};
  scene.physics.restitution = scene.physics.wall_restitution = 1;
  scene.physics.stiffness = stiffness;
  for (const Vec3d& site : fcc_lattice(kCells, edge)) {
    put_sphere(scene, site + kDisturbed * random.uniform(Vec3d(-1.0), Vec3d(1.0)), Vec3d(0.0), 0.5, 1.0);
  }
  return scene;
}

double largest_speed(World& world) {
  double largest = 0;
  for (const Vec3d& v : world.bodies().velocity) largest = std::max(largest, length(v));
  return largest;
}

}  // namespace

double spring_growth(double dt, double stiffness) {
  constexpr int kSteps = 300;
  Settings settings = settings_of("penalty", dt, "velocity-verlet");
  settings.max_energy = 1e15;  // the failure is to be seen
  const auto world = make_world_on_cpu(crystal(stiffness), settings);
  double largest = 1;
  int steps = 0;
  while (steps < kSteps && largest < kGrown) {
    world->step();
    ++steps;
    largest = std::max(largest, largest_speed(*world) * dt / kDisturbed);
  }
  return std::pow(largest, 1.0 / steps);
}

double part_of_hits_seen(double step, double impact, int phases, bool is_swept) {
  const int steps = static_cast<int>(2 / step) + 4;  // from before the other sphere to behind it
  const double lane = 3;                             // [m] from pair to pair
  const double half = std::max(lane * (phases + 1) / 2.0, 2 + steps * step);
  Scene scene = wide_box(half);
  for (int k = 0; k < phases; ++k) {
    const double y = lane * (k - (phases - 1) / 2.0), start = -1 - (1.5 + (k + 0.5) / phases) * step;
    put_sphere(scene, {start, y + impact, 0}, {1, 0, 0}, 0.5, 1);
    put_sphere(scene, {0, y, 0}, Vec3d(0.0), 0.5, 1);
  }
  Settings settings = settings_of("impulse", step);
  settings.is_swept = is_swept;
  const auto world = make_world_on_cpu(scene, settings);
  std::set<int> seen;  // the second sphere of each pair; a pair may touch while it parts, without an impulse
  for (int k = 0; k < steps; ++k) {
    for (const Pair& pair : world->inspect().contacts) seen.insert(pair.j);
    world->step();
  }
  const Bodies bodies = world->bodies();
  for (int j = 1; j < 2 * phases; j += 2) {
    if (length(bodies.velocity[static_cast<size_t>(j)]) > 0) seen.insert(j);
  }
  return static_cast<double>(seen.size()) / phases;
}

double recall_of_cells(double edge, int pairs, uint64_t seed) {
  const double spacing = 2 + edge;  // [diameters] from pair to pair, so that pairs do not touch
  const int side = static_cast<int>(std::ceil(std::cbrt(pairs)));
  Random random(seed);
  std::vector<Vec3> places;
  for (int k = 0; k < pairs; ++k) {
    const Vec3d corner(k % side, k / side % side, k / (side * side));
    const Vec3d at = spacing * corner + random.uniform(Vec3d(0.0), Vec3d(edge));  // uniform in a cell
    const Vec3d arm = (0.5 - 1e-5) * random.direction(3);
    places.push_back(narrow<Vec3>(at - arm));
    places.push_back(narrow<Vec3>(at + arm));
  }
  const float radius = 0.5f;
  Settings settings;
  settings.broadphase = BroadPhase::linked_cell;
  settings.cell_size = edge;
  settings.threads = 1;
  const auto search = cpu_backend().make_pair_search(settings);
  search->find({{places.data(), static_cast<int64_t>(places.size())}, {&radius, 1}});
  return static_cast<double>(search->report().contacts) / pairs;
}

double speed_left(const std::vector<double>& masses, int sweeps) {
  constexpr double kStep = 0.01;
  Scene scene = make_stack(masses, 0.05);
  for (size_t k = 0; k < masses.size(); ++k) scene.bodies.position[k].y -= 1e-9 * static_cast<double>(k + 1);
  Settings settings = settings_of("impulse", kStep);
  settings.solver = Solver::gauss_seidel;
  settings.correction = Correction::none;
  settings.iterations = sweeps;
  const auto world = make_world_on_cpu(scene, settings);
  world->step();
  return largest_speed(*world) / (-scene.physics.gravity.y * kStep);
}

double part_of_way(double x, double step) {
  constexpr int kSteps = 16;
  Scene scene;
  scene.domain = {Vec3d(-2 * x), Vec3d(2 * x), Boundary::walls, 3};
  put_sphere(scene, {x, 0, 0}, {step, 0, 0}, x / 1024, 1);
  Settings settings = settings_of("impulse", 1);
  settings.precision = Precision::float32;
  const auto world = make_world_on_cpu(scene, settings);
  const double start = world->bodies().position[0].x;  // x, rounded
  for (int k = 0; k < kSteps; ++k) world->step();
  return (world->bodies().position[0].x - start) / (kSteps * step);
}

bool passes_through(double step, bool is_swept) {
  Scene scene = wide_box(10);
  put_sphere(scene, {-2.5 * step, 0, 0}, {1, 0, 0}, 0.05, 1);  // symmetric about the wall, two steps later
  for (int k = -2; k <= 2; ++k) put_sphere(scene, {0, 0.22 * k, 0}, Vec3d(0.0), 0.1, 1);
  Settings settings = settings_of("impulse", step);
  settings.is_swept = is_swept;
  const auto world = make_world_on_cpu(scene, settings);
  for (int k = 0; k < 5; ++k) world->step();
  return world->bodies().position[0].x > 0.2;
}

namespace {

using Values = std::vector<double>;

/// A column of cells that do not share measurements: the value for each y.
template <class Cell>
auto by_cell(const Cell& cell) {
  return [cell](double x, const Values& y, uint64_t) {
    Values values;
    for (const double at : y) values.push_back(cell(x, at));
    return values;
  };
}

double hits_seen(double step, double impact) { return part_of_hits_seen(step, impact, 800); }

/// The part of searches with at least this recall. Searches with the same cells differ by the places of the pairs.
Values cells(double edge, const Values& recall, uint64_t seed) {
  constexpr int kSearches = 40, kPairs = 1000;
  Values found;
  for (uint64_t k = 0; k < kSearches; ++k) found.push_back(recall_of_cells(edge, kPairs, seed * 1000 + k));
  const auto part = [&](double, double least) {
    return static_cast<double>(std::ranges::count_if(found, [&](double one) { return one >= least; })) / kSearches;
  };
  return by_cell(part)(edge, recall, seed);
}

double in_tall_stack(double spheres, double sweeps) {
  return speed_left(Values(static_cast<size_t>(std::lround(spheres)), 1.0), static_cast<int>(std::lround(sweeps)));
}

double in_heavy_stack(double ratio, double sweeps) {
  return speed_left({1.0, ratio}, static_cast<int>(std::lround(sweeps)));
}

double largest_stiffness(double dt) { return 0.5 / (dt * dt); }  // dt = √(m/(2k)), twelve contacts each; m = 1
double largest_impact(double step) { return step < 2 ? std::sqrt(1 - step * step / 4) : 0; }

bool is_unstable(double growth) { return growth > kStableGrowth; }
bool is_below_one(double part) { return part < 1; }
bool is_below_half(double part) { return part < 0.5; }
bool is_below_percent(double left) { return left < 0.01; }
bool has_moved(double part) { return part > 0; }

}  // namespace

const std::vector<FailureMap>& failure_maps() {
  const Axis sweeps{"sweeps of Gauss–Seidel", "", Scale::log}, left{"speed left", "", Scale::log, 1e-4, 1};
  static const std::vector<FailureMap> table{
      {"springs", "Springs explode where the step is too large for their stiffness",
       MapAxis{Axis{"step dt", "s", Scale::log}, 1e-4, 1e-2, 17},
       MapAxis{Axis{"stiffness k", "N/m", Scale::log}, 1e3, 1e8, 21}, Axis{"growth a step", "", Scale::log, 1, 3},
       "k = m/(2·dt²)", "a packing with twelve contacts each begins to grow", by_cell(spring_growth), is_unstable,
       largest_stiffness},
      {"tunnelling", "Where a step is longer than the chord, hits go unseen", MapAxis{{"step v·dt/D"}, 0.1, 3.9, 20},
       MapAxis{{"impact parameter b/D"}, 0.03125, 0.96875, 16}, Axis{"part of hits seen", "", Scale::linear, 0, 1},
       "2√(1 − b²/D²)", "the first hit is missed", by_cell(hits_seen), is_below_one, largest_impact},
      {"cell-size", "Cells smaller than a diameter lose contacts", MapAxis{{"cell edge c/D"}, 0.4, 1.1, 15},
       MapAxis{{"recall: contacts found"}, 0.025, 0.975, 20}, Axis{"part of searches", "", Scale::linear, 0, 1},
       "⟨∏ (2 − |d|/c)⟩", "half of the searches find less", cells, is_below_half, cell_recall},
      {"tall-stack", "A stack twice as tall needs four times the sweeps",
       MapAxis{{"spheres n in the stack"}, 4, 40, 10}, MapAxis{sweeps, 8, 4096, 19}, left, "1.866·n²",
       "a percent of the error is left", by_cell(in_tall_stack), is_below_percent, stack_sweeps},
      {"mass-ratio", "A load R times as heavy needs R times the sweeps",
       MapAxis{Axis{"mass ratio R", "", Scale::log}, 1, 1000, 13}, MapAxis{sweeps, 4, 8192, 23}, left,
       "ln 100/ln(1+1/R)", "a percent of the error is left", by_cell(in_heavy_stack), is_below_percent, ratio_sweeps},
      {"far-out", "Far from the origin, single precision stands still",
       MapAxis{Axis{"place x", "m", Scale::log}, 96, 6291456, 17},
       MapAxis{Axis{"step v·dt", "m", Scale::log}, 1e-6, 1, 19}, Axis{"way made", "", Scale::linear, 0, 2}, "ulp(x)/2",
       "a sphere in single precision begins to move", by_cell(part_of_way), has_moved, frozen_step},
  };
  return table;
}

}  // namespace ballpit
