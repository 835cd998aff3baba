// SPDX-License-Identifier: MIT
// The same scene moves bit-identically with every broad phase, on any number of threads, sorted in memory or not,
// and after a new start from its own state: with every response, in both precisions.
#include <algorithm>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "methods/methods.h"
#include "tests/support/hits.h"
#include "tests/support/inputs.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

// Threads are made anew for each launch under the thread sanitizer, which takes its time.
#ifdef __SANITIZE_THREAD__
constexpr int kSteps = 20;
#else
constexpr int kSteps = 500;
#endif

std::unique_ptr<World> world_after(const Scene& scene, int steps, const Settings& settings) {
  auto world = make_cpu_world(scene, settings);
  for (int k = 0; k < steps; ++k) world->step();
  return world;
}

uint64_t hash_after(const Scene& scene, int steps, const Way& way) {
  Settings settings = settings_of(way);
  settings.dt = 1.0 / 480;
  return world_after(scene, steps, settings)->report().state_hash;
}

/// Every broad phase, with and without a skin, on this number of threads.
std::vector<Way> ways_on(int threads) {
  std::vector<Way> list;
  for (const std::string_view method : kNames<BroadPhase>) {
    for (const double skin : {0.0, 0.1})
      list.push_back({.broadphase = std::string(method), .threads = threads, .skin = skin});
  }
  list.push_back({.broadphase = "sorted-grid", .table = "hashed", .threads = threads});
  return list;
}

void check_hashes(const Scene& scene, int steps) {
  const uint64_t expected = hash_after(scene, steps, {.broadphase = "brute-force"});
  CHECK(hash_after(scene, steps - 1, {.broadphase = "brute-force"}) != expected);
  for (const int threads : {1, 2, 8}) {
    for (const Way& way : ways_on(threads)) {
      INFO(way);
      CHECK(hash_after(scene, steps, way) == expected);
    }
  }
}

/// A response with what it goes by, in one precision.
struct PreciseKind {
  std::string response;
  std::string integrator = "auto";
  std::string solver = "jacobi";
  double restitution = 0.7;
  bool is_swept = false;
  std::string precision = "float";

  Settings settings(const Way& way = {}) const {
    Settings settings = settings_of(way);
    settings.response = named<Response>(response);
    settings.integrator = named<Integrator>(integrator);
    settings.solver = named<Solver>(solver);
    settings.is_swept = is_swept;
    settings.precision = named<Precision>(precision);
    settings.dt = 1.0 / 480;
    settings.max_energy = 1e15;  // explicit Euler gains it
    return settings;
  }
};

std::ostream& operator<<(std::ostream& out, const PreciseKind& kind) {
  return out << kind.response << ", integrator " << kind.integrator << ", solver " << kind.solver
             << ", e = " << kind.restitution << (kind.is_swept ? ", swept, " : ", ") << kind.precision;
}

/// Each in both precisions. Without losses velocity Verlet keeps accelerations from step to step.
std::vector<PreciseKind> precise_kinds() {
  std::vector<PreciseKind> list;
  for (const char* const precision : {"float", "double"}) {
    for (PreciseKind kind :
         {PreciseKind{"kinematic"}, PreciseKind{.response = "kinematic", .is_swept = true},
          PreciseKind{"impulse", "auto", "jacobi"}, PreciseKind{"impulse", "auto", "gauss-seidel"},
          PreciseKind{.response = "impulse", .is_swept = true}, PreciseKind{"penalty", "velocity-verlet"},
          PreciseKind{"penalty", "velocity-verlet", "jacobi", 1.0}, PreciseKind{"penalty", "symplectic-euler"},
          PreciseKind{"penalty", "explicit-euler"}, PreciseKind{"penalty", "rk4"}, PreciseKind{"position-based"}}) {
      kind.precision = precision;
      list.push_back(kind);
    }
  }
  return list;
}

Scene crowd(int dimensions, Boundary boundary, const PreciseKind& kind, int side = 0) {
  if (side == 0) side = dimensions == 2 ? 12 : 6;
  return make_crowd(dimensions, side, boundary, kind.restitution, 0.05, 0.07);
}

/// The same; for the position-based response of smaller spheres, none of which overlap. Where they do at the start, it also
/// knows how long ago that was, which positions and velocities do not tell.
Scene crowd_to_save(int dimensions, Boundary boundary, const PreciseKind& kind, int side = 0) {
  Scene scene = crowd(dimensions, boundary, kind, side);
  if (kind.response == "position-based") {
    for (double& radius : scene.bodies.radius) radius *= 0.75;
  }
  return scene;
}

/// Pairs that meet in steps 20 to 80, about when the bodies are sorted in memory a second time, each alone in its cell of a
/// lattice; every `stride`-th of them. One pair is like no other, and neighbours in space are far apart in memory.
Scene pairs_apart(int side, int stride, const PreciseKind& kind) {
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(side), Boundary::walls, 3};
  scene.physics.restitution = scene.physics.wall_restitution = kind.restitution;
  scene.physics.stiffness = 1000;  // a contact lasts about 33 steps
  const int count = side * side * side;
  Random random(11);
  for (int k = 0; k < count; ++k) {
    const int c = static_cast<int>(int64_t(k) * 977 % count);
    const Vec3d center = Vec3d(c % side, c / side % side, c / side / side) + 0.5, n = random.direction(3);
    const double speed = random.uniform(0.2, 0.5), radius = random.uniform(0.08, 0.1), mass = random.uniform(0.5, 1.5);
    const double apart = radius + 0.09 + speed * random.uniform(20.0, 80.0) / 480;
    if (k % stride != 0) continue;
    add_sphere(scene, center + 0.5 * apart * n, -0.5 * speed * n, radius, mass);
    add_sphere(scene, center - 0.5 * apart * n, 0.5 * speed * n, 0.09, 1.0);
  }
  return scene;
}

}  // namespace

TEST_CASE(
    "the state has the same bits after 500 steps for any number of threads, every broad phase, with a skin or "
    "without",
    "[slow]") {
  const int dimensions = GENERATE(2, 3);
  check_hashes(falling_cloud(dimensions == 2 ? 150 : 600, dimensions), kSteps);
}

TEST_CASE("the state of a periodic gas of unequal spheres has the same bits whatever finds its contacts") {
  check_hashes(make_cloud({.count = 600, .smallest = 0.03, .largest = 0.1, .boundary = Boundary::periodic}, 5),
               kSteps / 5);
}

TEST_CASE("the state of so many spheres that they are sorted in memory has the same bits whatever finds their contacts",
          "[slow]") {
  // Past a second sorting, in step 64; two in a thousand of the heap move fast enough to end a skin.
  Scene scene = make_cloud({.count = 4500, .smallest = 0.03, .largest = 0.045}, 5);
  scene.physics.gravity = {0, -9.81, 0};
  for (Vec3d& p : scene.bodies.position) p = glm::clamp(p, Vec3d(-0.9), Vec3d(0.9));
  check_hashes(scene, kSteps > 100 ? 70 : 3);
}

TEST_CASE("with every response, in both precisions, the state is bit-identical for all broad phases", "[slow]") {
  constexpr int kThreads[] = {1, 2, 8};
  int turn = 0;
  for (const PreciseKind& kind : precise_kinds()) {
    const int dimensions = 2 + turn % 2;
    const Boundary boundary = turn / 2 % 2 == 0 ? Boundary::walls : Boundary::periodic;
    const Scene scene = crowd(dimensions, boundary, kind);
    const uint64_t expected =
        world_after(scene, kSteps / 8, kind.settings({.broadphase = "brute-force"}))->report().state_hash;
    for (int run = 0; run < 2; ++run) {  // twice, on other threads
      for (Way way : ways_on(1)) {
        way.threads = kThreads[turn++ % 3];
        INFO(kind << "; " << way << ", dimensions " << dimensions);
        CHECK(world_after(scene, kSteps / 8, kind.settings(way))->report().state_hash == expected);
      }
    }
    ++turn;
  }
}

TEST_CASE("near contacts of the position-based response are found within a skin that the guard's search began") {
  // The guard lists spheres as large as they are, the response asks for those nearer than its margin, 0.01 r + g·dt² each.
  // Two that start just beyond their skins come so near within them. Which contacts there are decides their colours, and so
  // the order in which a stack is solved.
  const PreciseKind kind{"position-based"};
  Scene scene;
  scene.physics.gravity = {0, -9.81, 0};
  add_sphere(scene, {0.2, 0.05, 0.5}, {0.1, 0, 0});
  add_sphere(scene, {0.2 + 2 * 0.0551, 0.05, 0.5}, {-0.1, 0, 0});
  for (int k = 0; k < 6; ++k) add_sphere(scene, {0.7, 0.05 + 0.1 * k, 0.5});
  for (int steps = 20; steps < 30; ++steps) {
    INFO(steps << " steps");
    CHECK(world_after(scene, steps, kind.settings({.skin = 0.1}))->report().state_hash ==
          world_after(scene, steps, kind.settings({.skin = 0}))->report().state_hash);
  }
}

TEST_CASE("with every response, spheres that are sorted in memory move bit-identically to unsorted ones", "[slow]") {
  for (const PreciseKind& kind : precise_kinds()) {
    const Settings settings = kind.settings({.broadphase = "sorted-grid", .threads = 2});
    const int steps = kSteps > 100 ? 100 : 3;
    const Bodies many = world_after(pairs_apart(13, 1, kind), steps, settings)->bodies();
    const Bodies few = world_after(pairs_apart(13, 10, kind), steps, settings)->bodies();
    REQUIRE(many.size() >= 4096);
    REQUIRE(few.size() < 4096);
    INFO(kind);
    int64_t differing = 0;
    for (size_t i = 0; i < few.position.size(); ++i) {
      const size_t k = 20 * (i / 2) + i % 2;
      differing += !(few.position[i] == many.position[k] && few.velocity[i] == many.velocity[k]);
    }
    CHECK(differing == 0);
  }
}

TEST_CASE("looking at a world does not change its motion, by any response, with a skin or without") {
  for (const PreciseKind& kind : precise_kinds()) {
    const Scene scene = crowd(3, Boundary::walls, kind);
    for (const double skin : {0.0, 0.1}) {
      const Settings settings = kind.settings({.skin = skin});
      const auto watched = make_cpu_world(scene, settings), alone = make_cpu_world(scene, settings);
      for (int k = 0; k < kSteps / 8; ++k) {
        (void)watched->inspect();
        (void)watched->report();
        watched->step();
        alone->step();
      }
      INFO(kind << ", skin " << skin);
      CHECK(watched->report().state_hash == alone->report().state_hash);
    }
  }
}

TEST_CASE("a world started from another's bodies continues bit-identically, with every response") {
  for (const PreciseKind& kind : precise_kinds()) {
    for (const Boundary boundary : {Boundary::walls, Boundary::periodic}) {
      Scene scene = crowd_to_save(boundary == Boundary::walls ? 2 : 3, boundary, kind);
      const auto first = world_after(scene, 40, kind.settings());
      scene.bodies = first->bodies();
      const auto second = world_after(scene, 0, kind.settings());
      INFO(kind);
      CHECK(second->report().state_hash == first->report().state_hash);
      for (int k = 0; k < 40; ++k) {
        first->step();
        second->step();
      }
      CHECK(second->report().state_hash == first->report().state_hash);
    }
  }
}

TEST_CASE("a world that is large enough to be sorted continues bit-identically from a step that sorts it") {
  // Elsewhere the new world sorts its spheres at its own begin: forces on a sphere are then summed in another order. So they
  // are at any step where velocity Verlet keeps forces, without losses, from before the bodies were sorted.
  for (const PreciseKind& kind : {PreciseKind{"impulse"}, PreciseKind{"penalty"}, PreciseKind{"position-based"}}) {
    for (const int steps : {40, 64}) {
      Scene scene = crowd_to_save(2, Boundary::walls, kind, 65);
      REQUIRE(scene.bodies.size() >= 4096);
      const auto first = world_after(scene, steps, kind.settings());
      scene.bodies = first->bodies();
      const auto second = world_after(scene, 30, kind.settings());
      for (int k = 0; k < 30; ++k) first->step();
      INFO(kind << ", " << steps << " steps");
      CHECK((second->report().state_hash == first->report().state_hash) == (steps == 64));
      CHECK(length(second->bodies().position[2000] - first->bodies().position[2000]) < 1e-3);
    }
  }
}

TEST_CASE("a world that changes its broad phase in between moves bit-identically") {
  for (const PreciseKind& kind : precise_kinds()) {
    for (const int dimensions : {2, 3}) {
      INFO(kind << ", dimensions " << dimensions);
      const Scene scene = crowd(dimensions, Boundary::walls, kind);
      const auto expected = world_after(scene, 40, kind.settings({.broadphase = "brute-force"}));
      const auto world = world_after(scene, 5, kind.settings({.broadphase = "brute-force"}));
      for (const Way& way : ways_on(2)) {
        REQUIRE(world->detect_by(kind.settings(way)));
        world->step();
        if (way.broadphase != "auto") CHECK(world->report().broadphase == way.broadphase);
      }
      while (world->steps() < 40) world->step();
      CHECK(world->report().state_hash == expected->report().state_hash);
    }
  }
}

TEST_CASE("a change of the broad phase that cannot be leaves the world as it was") {
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(1000.0), Boundary::walls, 3};
  add_sphere(scene, Vec3d(500.0), Vec3d(1.0), 0.05, 1.0);
  add_sphere(scene, Vec3d(500.09, 500, 500), Vec3d(0.0), 0.05, 1.0);
  Settings too_fine;  // far more cells than can be numbered
  too_fine.broadphase = BroadPhase::linked_cell;
  too_fine.table = CellTable::dense;
  too_fine.cell_size = 0.05;
  for (const char* const method : {"brute-force", "linked-cell", "sorted-grid"}) {
    Settings settings;
    settings.broadphase = named<BroadPhase>(method);
    settings.table = CellTable::hashed;
    const auto world = world_after(scene, 3, settings), twin = world_after(scene, 4, settings);
    CHECK_THROWS_AS(world->detect_by(too_fine), UserError);
    world->step();
    const Inspection seen = world->inspect({.candidates = true, .missed = true});
    CHECK(seen.contacts == twin->inspect().contacts);
    CHECK(world->report().broadphase == method);
    CHECK(world->report().state_hash == twin->report().state_hash);
  }
}
