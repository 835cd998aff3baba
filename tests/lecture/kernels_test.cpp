// SPDX-License-Identifier: MIT
// The slides' kernels on recorded memory. As broad phases they are tested with all others: tests/narrow_phase.
#include <algorithm>

#include <catch2/catch.hpp>

#include "lecture/kernels/brute_force.h"
#include "lecture/kernels/linked_cell.h"
#include "lecture/kernels/sort_and_sweep.h"
#include "lecture/record.h"
#include "tests/support/body_arrays.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;
using namespace ballpit::lecture;

namespace {

using Memory = RecordedMemory;

/// The pairs that a record's tests found, sorted, and how many tests there were.
std::vector<Pair> contacts_of(const Record& record) {
  std::vector<Pair> pairs;
  for (const Operation& operation : record.operations) {
    if (operation.action != Action::test || operation.value == 0) continue;
    const int i = static_cast<int>(operation.index), j = operation.other;
    pairs.push_back({std::min(i, j), std::max(i, j)});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// The sweep scene's list is b0 e0 b1 b2 e1 e2, as on slide 3.
struct SweepDesk {
  BodyArrays<Vec2> bodies;
  std::vector<int> list;
  Recorder recorder;
  SortAndSweep<Vec2, Memory> kernels;

  explicit SweepDesk(const Scene& scene) : bodies(scene), list(2 * size_t(bodies.count()), 0) {
    recorder.name("list", span());
    kernels = {
        recorder.memory(), {bodies.view().position, bodies.view().radius, bodies.box}, {}, span(), 0, 1e-6f, false};
  }
  Span<int> span() { return {list.data(), static_cast<int64_t>(list.size())}; }
};

}  // namespace

TEST_CASE("on record, sort and sweep stores 2n entries, sorts them, and walks from each begin to its end") {
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(10.0), Boundary::walls, 2};
  for (const Vec3d& p : {Vec3d(5, 5, 0), Vec3d(1, 5, 0), Vec3d(5.9, 5.3, 0)}) add_sphere(scene, p, Vec3d(0.0), 0.5);
  SweepDesk desk(scene);
  desk.recorder.run(3, [&](int i) { desk.kernels.store_entries(i); });
  CHECK(desk.list == std::vector<int>{0, 2, 4, 1, 3, 5});
  desk.recorder.run(1, [&](int t) { desk.kernels.sort(t); });
  CHECK(desk.list == std::vector<int>{2, 3, 0, 4, 1, 5});
  desk.recorder.run(6, [&](int t) { desk.kernels.collide(t); });
  CHECK(contacts_of(desk.recorder.record()) == std::vector<Pair>{{0, 2}});
  CHECK(contacts_of(desk.recorder.record()) == pairs_by_definition(scene));
}

namespace {

Scene planar_scene(double size, Boundary boundary, const std::vector<Vec3d>& positions, double radius) {
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(size), boundary, 2};
  for (const Vec3d& p : positions) add_sphere(scene, p, Vec3d(0.0), radius);
  return scene;
}

/// The arrays of linked cells, on record.
template <class V>
struct CellDesk {
  BodyArrays<V> bodies;
  Grid<V> grid;
  std::vector<int> head, next;
  Recorder recorder;
  LinkedCell<V, Memory> kernels;

  explicit CellDesk(const Scene& scene, double cell_size = 1, Mistakes mistakes = {}) : bodies(scene) {
    Settings settings;
    settings.cell_size = cell_size;
    const BroadPhaseParameters<V> parameters = bodies.parameters(settings);
    grid = make_grid(parameters, {parameters.largest_radius(), parameters.count}, V(2 * parameters.largest_radius()),
                     false);
    head.assign(static_cast<size_t>(grid.size()), 0);
    next.assign(static_cast<size_t>(bodies.count()), 0);
    recorder.name("head", {head.data(), grid.size()});
    recorder.name("next", {next.data(), bodies.count()});
    kernels = {recorder.memory(),
               {bodies.view().position, bodies.view().radius, bodies.box},
               {},
               grid,
               {head.data(), grid.size()},
               {next.data(), bodies.count()},
               mistakes};
  }

  void clear() {
    recorder.run(static_cast<int>(head.size()), [&](int cell) { kernels.clear(cell); });
  }
  void insert(const Interleaving& interleaving = {}) {
    recorder.run(
        bodies.count(), [&](int i) { kernels.insert(i); }, interleaving);
  }
  void insert_racing(const Interleaving& interleaving) {
    recorder.run(
        bodies.count(), [&](int i) { kernels.insert_racing(i); }, interleaving);
  }
  std::vector<Pair> collide() {
    recorder.run(bodies.count(), [&](int i) { kernels.collide(i); });
    return contacts_of(recorder.record());
  }
};

}  // namespace

TEST_CASE("on record, particles 6 and 2 enter cell 4 as on slides 13 to 15") {
  std::vector<Vec3d> positions;
  for (int k = 0; k < 9; ++k) positions.push_back({k == 2 || k == 6 ? 1.5 : 0.5, k == 2 || k == 6 ? 1.5 : 0.5, 0});
  CellDesk<Vec2> desk(planar_scene(3, Boundary::walls, positions, 0.4), 1 / 0.8);
  REQUIRE(desk.head.size() == 9);
  desk.clear();
  CHECK(desk.head == std::vector<int>(9, -1));
  desk.insert({6, 6, 2, 2});
  const Record& record = desk.recorder.record();
  const auto is_shared_by = [](int thread) {
    return [thread](const Operation& o) { return o.thread == thread && o.action == Action::exchange && o.index == 4; };
  };
  const auto six = std::find_if(record.operations.begin(), record.operations.end(), is_shared_by(6));
  const auto two = std::find_if(record.operations.begin(), record.operations.end(), is_shared_by(2));
  REQUIRE(six != record.operations.end());
  REQUIRE(two != record.operations.end());
  CHECK(six->old_value == -1);
  CHECK(six->value == 6);
  CHECK(two->old_value == 6);
  CHECK(two->value == 2);
  CHECK(desk.head[4] == 2);
  CHECK(desk.next[2] == 6);
  CHECK(desk.next[6] == -1);
}

TEST_CASE("slide 16: two threads that load the same old value lose a sphere and its contact, atomicExch keeps it") {
  // Spheres 0 and 1 in one cell. Both threads load −1 before either has stored; thread 0 stores last, so sphere 1 is
  // lost. (Where sphere 0 is lost, its own thread still finds sphere 1 in the list, and the contact.)
  const Scene scene = planar_scene(5, Boundary::walls, {{2.3, 2.5, 0}, {2.7, 2.5, 0}, {0.5, 0.5, 0}}, 0.3);
  CellDesk<Vec2> racing(scene, 1 / 0.6);
  racing.clear();
  racing.insert_racing({0, 1, 1, 0});
  CHECK(racing.collide().empty());
  CellDesk<Vec2> atomic(scene, 1 / 0.6);
  atomic.clear();
  atomic.insert({0, 1, 1, 0});
  CHECK(atomic.collide() == std::vector<Pair>{{0, 1}});
}

TEMPLATE_TEST_CASE("on record, linked cells find every contact, in any interleaving", "", Vec2, Vec3) {
  const Cloud cloud{.count = 60,
                    .dimensions = kDimensions<TestType>,
                    .smallest = 0.05,
                    .largest = 0.2,
                    .boundary = GENERATE(Boundary::walls, Boundary::periodic)};
  for (uint64_t seed = 1; seed < 6; ++seed) {
    const Scene scene = make_cloud(cloud, seed);
    CellDesk<TestType> desk(scene);
    desk.clear();
    Random random(seed);
    Interleaving order;
    for (int k = 0; k < 200; ++k) order.push_back(static_cast<int>(random.uniform(0, 59.999)));
    desk.insert(order);
    const std::vector<Pair> expected = pairs_by_definition(scene);
    CHECK(expected.size() > 5);
    CHECK(difference(desk.collide(), expected) == "");
  }
}

TEST_CASE("int() for floor puts a sphere below zero into the wrong cell, and its contact is missed") {
  // Not yet wrapped into the domain: −0.5 belongs to the last cell.
  const Scene scene = planar_scene(5, Boundary::periodic, {{-0.4, 2.5, 0}, {3.7, 2.5, 0}}, 0.5);
  CellDesk<Vec2> right(scene), wrong(scene, 1, {.truncates = true});
  for (CellDesk<Vec2>* desk : {&right, &wrong}) {
    desk->clear();
    desk->insert();
  }
  CHECK(right.collide() == std::vector<Pair>{{0, 1}});
  CHECK(wrong.collide().empty());
}

TEST_CASE("without the cells beyond a periodic border, contacts across it are missed") {
  const Scene scene = planar_scene(5, Boundary::periodic, {{0.2, 2.5, 0}, {4.6, 2.5, 0}}, 0.4);
  CellDesk<Vec2> right(scene, 1.25), wrong(scene, 1.25, {.forgets_wrap = true});
  for (CellDesk<Vec2>* desk : {&right, &wrong}) {
    desk->clear();
    desk->insert();
  }
  CHECK(right.collide() == std::vector<Pair>{{0, 1}});
  CHECK(wrong.collide().empty());
}

TEST_CASE("who tests both halves of a pair finds each contact twice") {
  const Scene scene = planar_scene(5, Boundary::walls, {{2.3, 2.5, 0}, {2.7, 2.5, 0}}, 0.3);
  CellDesk<Vec2> desk(scene, 1, {.tests_twice = true});
  desk.clear();
  desk.insert();
  CHECK(desk.collide() == std::vector<Pair>{{0, 1}, {0, 1}});
}
