// SPDX-License-Identifier: MIT
// Worlds on CUDA equal worlds on the CPU: the same contacts, the same bits of motion.
#include <catch2/catch.hpp>

#include "methods/methods.h"
#include "scene/read_scene.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

Settings settings_of(const std::string& broadphase, double skin = 0) {
  Settings settings;
  settings.broadphase = named<BroadPhase>(broadphase);
  settings.skin = skin;
  settings.dt = 1.0 / 480;
  settings.threads = 2;
  return settings;
}

struct Twins {
  std::unique_ptr<World> cpu, cuda;

  Twins(const Scene& scene, const Settings& settings)
      : cpu(cpu_backend().make_world(scene, settings)), cuda(cuda_backend().make_world(scene, settings)) {}

  void step(int steps) const {
    for (int k = 0; k < steps; ++k) {
      cpu->step();
      cuda->step();
    }
  }

  /// Compares what both report of their state; returns the number of contacts.
  int64_t compare() const {
    const Report expected = cpu->report(), report = cuda->report();
    CHECK(report.state_hash == expected.state_hash);
    CHECK(report.broadphase == expected.broadphase);
    CHECK(report.broadphase_reason == expected.broadphase_reason);
    CHECK(report.searches == expected.searches);
    CHECK(report.candidates == expected.candidates);
    CHECK(report.contacts == expected.contacts);
    CHECK(report.kinetic_energy == expected.kinetic_energy);
    CHECK(report.potential_energy == expected.potential_energy);
    CHECK(report.momentum == expected.momentum);
    CHECK(report.max_overlap == expected.max_overlap);
    return report.contacts;
  }
};

Scene heap(const Cloud& cloud) {
  Scene scene = make_cloud(cloud, 5);
  scene.physics.gravity = {0, -9.81, 0};
  for (Vec3d& p : scene.bodies.position) p = glm::clamp(p, Vec3d(cloud.low * 0.9), Vec3d(cloud.high * 0.9));
  if (cloud.dimensions == 2) {
    for (Vec3d& p : scene.bodies.position) p.z = 0;
  }
  return scene;
}

}  // namespace

TEST_CASE("CUDA finds the contacts that the CPU finds, by every broad phase", "[sanitized]") {
  const std::string broadphase = GENERATE("brute-force", "sort-and-sweep", "linked-cell", "sorted-grid");
  const std::string table = GENERATE("dense", "hashed");
  const Cloud cloud = GENERATE(
      Cloud{.count = 200, .smallest = 0.1, .largest = 0.1}, Cloud{.count = 200, .smallest = 0.02, .largest = 0.2},
      Cloud{.count = 200, .dimensions = 2, .smallest = 0.05, .largest = 0.05},
      Cloud{.count = 200, .smallest = 0.125, .largest = 0.125, .snap = 0.25},
      Cloud{.count = 200, .smallest = 0.1, .largest = 0.1, .boundary = Boundary::open_top},
      Cloud{.count = 200, .smallest = 0.1, .largest = 0.1, .boundary = Boundary::periodic},
      Cloud{.count = 200, .smallest = 0.02, .largest = 0.2, .boundary = Boundary::periodic},
      Cloud{.count = 60, .smallest = 0.45, .largest = 0.45, .boundary = Boundary::periodic},
      Cloud{.count = 200, .dimensions = 2, .smallest = 0.02, .largest = 0.1, .boundary = Boundary::periodic});
  if (table == "hashed" && (broadphase == "brute-force" || broadphase == "sort-and-sweep")) return;
  Settings settings = settings_of(broadphase);
  settings.table = named<CellTable>(table);
  const Twins worlds(make_cloud(cloud, 3), settings);
  const Inspection cpu = worlds.cpu->inspect(), cuda = worlds.cuda->inspect();
  CAPTURE(broadphase, table, cloud.dimensions, cloud.largest, static_cast<int>(cloud.boundary));
  REQUIRE(cpu.contacts.size() > 10);
  CHECK(cuda.contacts == cpu.contacts);
  CHECK(worlds.cuda->report().candidates == worlds.cpu->report().candidates);
  REQUIRE(cuda.grids.size() == cpu.grids.size());
  for (size_t k = 0; k < cuda.grids.size(); ++k) {
    CHECK(cuda.grids[k].cells == cpu.grids[k].cells);
    if (broadphase == "linked-cell" && table == "dense") continue;  // the order within a list is that of the exchanges
    CHECK(cuda.grids[k].head == cpu.grids[k].head);
    CHECK(cuda.grids[k].next == cpu.grids[k].next);
  }
}

TEST_CASE("CUDA shows the candidates, missed pairs, endpoints and work that the CPU shows") {
  const std::string broadphase = GENERATE("brute-force", "sort-and-sweep", "linked-cell", "sorted-grid");
  const std::string table = GENERATE("dense", "hashed");
  const Cloud cloud = GENERATE(
      Cloud{.count = 200, .smallest = 0.1, .largest = 0.1}, Cloud{.count = 200, .smallest = 0.02, .largest = 0.2},
      Cloud{.count = 200, .dimensions = 2, .smallest = 0.05, .largest = 0.05, .boundary = Boundary::periodic});
  Settings settings = settings_of(broadphase);
  settings.table = named<CellTable>(table);
  settings.cell_size = 0.5;
  const Twins worlds(make_cloud(cloud, 3), settings);
  const Wanted all{true, true, true, true, true};
  const Inspection cpu = worlds.cpu->inspect(all), cuda = worlds.cuda->inspect(all);
  CAPTURE(broadphase, table, cloud.dimensions, cloud.largest);
  CHECK(cuda.candidates == cpu.candidates);
  CHECK(cuda.missed == cpu.missed);
  CHECK(cuda.axis == cpu.axis);
  REQUIRE(cuda.endpoints.size() == cpu.endpoints.size());
  for (size_t p = 0; p < cpu.endpoints.size(); ++p) {
    CHECK(cuda.endpoints[p].at == cpu.endpoints[p].at);
    CHECK(cuda.endpoints[p].body == cpu.endpoints[p].body);
    CHECK(cuda.endpoints[p].is_end == cpu.endpoints[p].is_end);
  }
  CHECK(cuda.work == cpu.work);
  CHECK(cuda.worker == cpu.worker);
}

TEST_CASE("the state on CUDA has the bits that it has on the CPU, by every broad phase, with a skin and without") {
  const std::string broadphase = GENERATE("brute-force", "sort-and-sweep", "linked-cell", "sorted-grid", "auto");
  const double skin = GENERATE(0.0, 0.3);
  const Cloud cloud = GENERATE(Cloud{.count = 150, .smallest = 0.1, .largest = 0.15},
                               Cloud{.count = 100, .dimensions = 2, .smallest = 0.05, .largest = 0.05});
  CAPTURE(broadphase, skin, cloud.dimensions);
  const Twins worlds(heap(cloud), settings_of(broadphase, skin));
  worlds.step(12);
  CHECK(worlds.compare() > 10);
}

TEST_CASE("periodic worlds on CUDA have the bits that they have on the CPU") {
  const std::string broadphase = GENERATE("sort-and-sweep", "linked-cell", "sorted-grid");
  const double skin = GENERATE(0.0, 0.3);
  CAPTURE(broadphase, skin);
  const Scene scene = make_cloud({.count = 150, .smallest = 0.1, .largest = 0.15, .boundary = Boundary::periodic}, 6);
  const Twins worlds(scene, settings_of(broadphase, skin));
  worlds.step(12);
  CHECK(worlds.compare() > 10);
}

TEST_CASE("bodies sorted in memory on CUDA move as on the CPU") {
  // So many bodies are sorted before the first step, and before the 65th.
  const std::string broadphase = GENERATE("sorted-grid", "linked-cell");
  const double skin = broadphase == "sorted-grid" ? 0.0 : 0.4;
  const Scene scene = heap({.count = 4200, .low = -1.5, .high = 1.5, .smallest = 0.06, .largest = 0.1});
  const Twins worlds(scene, settings_of(broadphase, skin));
  CAPTURE(broadphase, skin);
  worlds.step(broadphase == "sorted-grid" ? 66 : 3);
  CHECK(worlds.compare() > 100);
  const Inspection cpu = worlds.cpu->inspect(), cuda = worlds.cuda->inspect();
  CHECK(cuda.contacts == cpu.contacts);
  CHECK(cuda.bodies.position == cpu.bodies.position);
  CHECK(cuda.bodies.radius == cpu.bodies.radius);
}

TEST_CASE("every response moves worlds on CUDA by the bits that it has on the CPU, in single and double precision") {
  struct Way {
    const char *response, *integrator, *solver;
    bool is_swept;
  };
  const Way way =
      GENERATE(Way{"kinematic", "auto", "jacobi", false}, Way{"kinematic", "auto", "jacobi", true},
               Way{"impulse", "auto", "jacobi", true}, Way{"impulse", "auto", "gauss-seidel", false},
               Way{"penalty", "explicit-euler", "jacobi", false}, Way{"penalty", "symplectic-euler", "jacobi", false},
               Way{"penalty", "velocity-verlet", "jacobi", false}, Way{"penalty", "rk4", "jacobi", false},
               Way{"position-based", "auto", "jacobi", false});
  const std::string precision = GENERATE("float", "double");
  const Cloud cloud = GENERATE(Cloud{.count = 120, .smallest = 0.1, .largest = 0.15},
                               Cloud{.count = 80, .dimensions = 2, .smallest = 0.05, .largest = 0.05},
                               Cloud{.count = 120, .smallest = 0.1, .largest = 0.15, .boundary = Boundary::periodic});
  Settings settings = settings_of("sorted-grid", std::string(way.response) == "penalty" ? 0.3 : 0.0);
  settings.response = named<Response>(way.response);
  settings.integrator = named<Integrator>(way.integrator);
  settings.solver = named<Solver>(way.solver);
  settings.is_swept = way.is_swept;
  settings.precision = named<Precision>(precision);
  settings.max_overlap = settings.max_energy = 1e15;
  settings.keeps_tally = true;
  CAPTURE(way.response, way.integrator, way.solver, way.is_swept, precision, cloud.dimensions);
  Scene scene = heap(cloud);
  scene.physics.stiffness = 1e3;
  scene.physics.shear = 1;
  const Twins worlds(scene, settings);
  worlds.step(4);
  const int64_t contacts = worlds.compare();
  CHECK((contacts > 5 || std::string(way.response) == "position-based"));  // which leaves few
  const Tally expected = worlds.cpu->report().tally, tally = worlds.cuda->report().tally;
  CHECK(expected.virial > 0);
  CHECK(tally.collisions == expected.collisions);
  CHECK(tally.wall_hits == expected.wall_hits);
  CHECK(tally.virial == expected.virial);
  CHECK(tally.floor_impulse == expected.floor_impulse);
  CHECK(worlds.cuda->report().elastic_energy == worlds.cpu->report().elastic_energy);
  CHECK(worlds.cuda->last_good().position == worlds.cpu->last_good().position);
}

TEST_CASE("spheres that are thrown and dropped in on CUDA move as on the CPU, also after going back") {
  for (const int count : {300, 4095}) {  // sorted in memory from the next one on
    const Scene scene = heap({.count = count, .smallest = 0.03, .largest = 0.05});
    Settings settings = settings_of("sorted-grid");
    settings.max_overlap = settings.max_energy = 1e15;
    const Twins twins(scene, settings);
    twins.step(10);
    const auto before = twins.cuda->snapshot();
    twins.step(10);
    Bodies bodies = twins.cpu->bodies();
    bodies.velocity[7] = {1, 2, 3};
    bodies.position.emplace_back(0.2, 0.93, 0.1);
    bodies.velocity.emplace_back(0.0);
    bodies.radius.push_back(0.06);
    bodies.mass.push_back(0.5);
    twins.cpu->replace(bodies);
    twins.cuda->replace(bodies);
    const auto after = twins.cuda->snapshot();
    twins.step(60);
    twins.compare();
    twins.cuda->restore(*before);
    CHECK(twins.cuda->shape().count == count);
    twins.cuda->restore(*after);
    for (int k = 0; k < 60; ++k) twins.cuda->step();
    CHECK(twins.cuda->report().state_hash == twins.cpu->report().state_hash);
  }
}

TEST_CASE("event-driven motion is refused on CUDA, with what is allowed") {
  Settings settings = settings_of("sorted-grid");
  settings.response = Response::event_driven;
  CHECK_THROWS_WITH(cuda_backend().make_world(heap({.count = 10}), settings), Catch::Contains("allowed auto, cpu"));
}

TEST_CASE("a sphere that leaves the domain is named on CUDA as on the CPU") {
  Scene scene = make_cloud({.count = 40, .smallest = 0.05, .largest = 0.05}, 7);
  scene.bodies.velocity[23] = {1e6, 0, 0};
  const Twins worlds(scene, settings_of("sorted-grid"));
  std::string expected, message;
  try {
    worlds.cpu->step();
  } catch (const std::exception& error) {
    expected = error.what();
  }
  try {
    worlds.cuda->step();
  } catch (const std::exception& error) {
    message = error.what();
  }
  CHECK_THAT(message, Catch::Contains("sphere 23 left the domain"));
  CHECK(message == expected);
}

TEST_CASE("every built-in scene moves on CUDA as on the CPU, in single and double precision, by each method") {
  for (const SceneInfo& info : built_in_scenes()) {
    const Scene scene = load_scene(info.name);
    Settings defaults;
    for (const DefaultOption& option : scene.defaults) apply_setting(defaults, option.key, option.value, option.where);
    if (defaults.response == Response::automatic) defaults.response = Response::impulse;
    if (!allowed_instead(defaults.response, "backend", "cuda").empty()) continue;
    for (const char* broadphase : {"sorted-grid", "linked-cell", "sort-and-sweep"}) {
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        Settings settings = defaults;
        settings.broadphase = named<BroadPhase>(broadphase);
        settings.skin = 0;
        settings.precision = precision;
        const Twins worlds(scene, settings);
        CAPTURE(info.name, broadphase, precision == Precision::float64);
        worlds.step(static_cast<int>(20000 / (scene.bodies.size() + 1000)));
        worlds.compare();
      }
    }
  }
}

TEST_CASE("worlds of zero, one and two spheres run on CUDA") {
  for (const std::string broadphase : {"brute-force", "sort-and-sweep", "linked-cell", "sorted-grid", "auto"}) {
    Scene scene;
    for (int n = 0; n <= 2; ++n) {
      CAPTURE(broadphase, n);
      const Twins worlds(scene, settings_of(broadphase, 0.1));
      worlds.step(2);
      CHECK(worlds.compare() == (n == 2 ? 1 : 0));
      add_sphere(scene, {0.4 + 0.09 * n, 0.5, 0.5}, {0.1, 0, 0});
    }
  }
}
