// SPDX-License-Identifier: MIT
// A recorded run of each slide's kernel: its phases, its contacts, and the lines of its source.
#include "lecture/recorded_run.h"

#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>

#include "lecture/real_race.h"
#include "scene/read_scene.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;
using namespace ballpit::lecture;

namespace {

BodySnapshot snapshot_of(const Scene& scene) { return make_cpu_world(scene, {})->inspect().bodies; }

RecordedRun record(KernelName kernel, const Scene& scene, const Interleaving& interleaving = {},
                   const Mistakes& mistakes = {}, double cell_size = 1) {
  Settings settings;
  settings.cell_size = cell_size;
  return record_kernel(kernel, snapshot_of(scene), scene.domain, settings,
                       {.interleaving = interleaving, .mistakes = mistakes});
}

/// Two spheres of radius 0.3 m in a square of 5 m, with cells of 0.6 m.
Scene planar_pair(const Vec3d& a, const Vec3d& b) {
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(5.0), Boundary::walls, 2};
  for (const Vec3d& p : {a, b}) add_sphere(scene, p, Vec3d(0.0), 0.3);
  scene.physics.initial_overlap = 1;
  return scene;
}

std::vector<std::string> lines_of(KernelName kernel) {
  std::istringstream text{std::string(kernel_source(kernel))};
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("every recorded kernel finds the contacts of clouds in the plane and in space, with walls or periodic") {
  for (const int dimensions : {2, 3}) {
    for (const Boundary boundary : {Boundary::walls, Boundary::open_top, Boundary::periodic}) {
      for (uint64_t seed = 1; seed <= 3; ++seed) {
        const Scene scene = make_cloud(
            {.count = 80, .dimensions = dimensions, .smallest = 0.05, .largest = 0.2, .boundary = boundary}, seed);
        const std::vector<Pair> expected = pairs_by_definition(scene);
        REQUIRE(expected.size() > 5);
        for (const KernelName kernel : {KernelName::brute_force, KernelName::sort_and_sweep, KernelName::linked_cell}) {
          INFO(name_of(kernel) << ", dimensions " << dimensions << ", boundary " << int(boundary) << ", seed " << seed);
          CHECK(difference(record(kernel, scene).found, expected) == "");
        }
      }
    }
  }
}

TEST_CASE("operations point to the lines of the source that perform them") {
  const Scene scene = make_cloud({.count = 20, .dimensions = 2, .smallest = 0.1, .largest = 0.2}, 1);
  struct Row {
    KernelName kernel;
    Action action;
    const char* phase;
    const char* text;
  };
  const Row row = GENERATE(values<Row>({
      {KernelName::brute_force, Action::test, "collide", "memory.test(i, j"},
      {KernelName::sort_and_sweep, Action::store, "store", "memory.store(&list["},
      {KernelName::sort_and_sweep, Action::store, "sort", "memory.store(&list[at]"},
      {KernelName::sort_and_sweep, Action::test, "sweep", "memory.test(i, j"},
      {KernelName::linked_cell, Action::store, "clear", "memory.store(&head[cell], -1)"},
      {KernelName::linked_cell, Action::compute, "insert", "memory.value(hash("},
      {KernelName::linked_cell, Action::exchange, "insert", "memory.atomicExch(&head[cell], i)"},
      {KernelName::linked_cell, Action::store, "insert", "memory.store(&next[i], old)"},
      {KernelName::linked_cell, Action::load, "collide", "memory.load("},
      {KernelName::race, Action::load, "insert", "memory.load_shared(&head[cell])"},
  }));
  INFO(name_of(row.kernel) << ", " << row.phase << ": " << row.text);
  const RecordedRun run = record(row.kernel, scene);
  const std::vector<std::string> lines = lines_of(row.kernel);
  const auto phase =
      std::find_if(run.phases.begin(), run.phases.end(), [&](const Phase& p) { return p.name == row.phase; });
  REQUIRE(phase != run.phases.end());
  int found = 0;
  for (size_t k = phase->first; k < phase->last; ++k) {
    const Operation& operation = run.record.operations[k];
    if (operation.action != row.action) continue;
    ++found;
    REQUIRE(lines.at(static_cast<size_t>(operation.line) - 1).find(row.text) != std::string::npos);
  }
  CHECK(found > 0);
}

TEST_CASE("phases follow each other without a gap, and the last one ends the record") {
  const Scene scene = make_cloud({.count = 10, .dimensions = 2, .smallest = 0.1, .largest = 0.2}, 1);
  for (const std::string_view name : kNames<KernelName>) {
    const RecordedRun run = record(named<KernelName>(name), scene);
    size_t end = 0;
    for (const Phase& phase : run.phases) {
      CHECK(phase.first == end);
      end = phase.last;
    }
    CHECK(end == run.record.operations.size());
    CHECK(run.phase_at(0).name == run.phases.front().name);
    CHECK(run.phase_at(end).name == run.phases.back().name);
  }
}

TEST_CASE("the sweep tests every other begin between a begin and its end: on slide 4 only 1 with 2") {
  const Scene scene = load_scene("lecture-sweep");
  const RecordedRun run = record(KernelName::sort_and_sweep, scene);
  REQUIRE(run.record.arrays.size() == 1);
  CHECK(run.axis == 0);
  const Phase& sweep = run.phases.back();
  CHECK(run.record.values_after(0, sweep.first) == std::vector<int>{0, 1, 2, 4, 3, 5});  // b0 e0 b1 b2 e1 e2
  CHECK(run.tests == 1);
  for (const Operation& operation : run.record.operations) {
    if (operation.action == Action::test) {
      CHECK(operation.index == 1);
      CHECK(operation.other == 2);
    }
  }
}

TEST_CASE("on slide 9, sphere 0 of the lecture's grid is hashed to cell 6") {
  const RecordedRun run = record(KernelName::linked_cell, load_scene("lecture-grid"), {}, {}, 2);
  const auto hashed = std::find_if(run.record.operations.begin(), run.record.operations.end(),
                                   [](const Operation& o) { return o.action == Action::compute && o.thread == 0; });
  REQUIRE(hashed != run.record.operations.end());
  CHECK(hashed->value == 6);
  CHECK(run.grid->cells == IVec3(5, 5, 1));
}

TEST_CASE("int() for floor misses contacts across the border of a domain around zero") {
  const Scene scene = load_scene("lecture-zero");
  const std::vector<Pair> expected = pairs_by_definition(scene);
  REQUIRE(expected.size() == 3);
  CHECK(record(KernelName::linked_cell, scene, {}, {}, 1.98).found == expected);
  const RecordedRun wrong = record(KernelName::linked_cell, scene, {}, {.truncates = true}, 1.98);
  CHECK(wrong.found == std::vector<Pair>{{4, 5}});
  const std::vector<int> head = wrong.record.values_after(0, wrong.record.operations.size());
  for (int k = 0; k < 4; ++k) {  // no sphere is in the first row or column
    CHECK(head.at(static_cast<size_t>(k)) == -1);
    CHECK(head.at(static_cast<size_t>(4 * k)) == -1);
  }
}

TEST_CASE("far from the origin, positions in single precision miss contacts and invent others") {
  const Scene scene = load_scene("lecture-contacts");
  const BodySnapshot bodies = snapshot_of(scene);
  const std::vector<Pair> expected = pairs_by_definition(scene);
  const auto found_at = [&](double distance) {
    return record_kernel(KernelName::linked_cell, bodies, scene.domain, {}, {.distance = distance}).found;
  };
  CHECK(found_at(0) == expected);
  CHECK(found_at(64) == expected);
  CHECK(found_at(1 << 20) == std::vector<Pair>{{0, 2}, {3, 5}, {14, 17}, {16, 18}});
  CHECK(expected == std::vector<Pair>{{3, 5}, {9, 10}, {14, 17}, {16, 18}});
}

TEST_CASE("lists of an earlier moment miss contacts of spheres that have left their cells") {
  Scene scene = planar_pair({0.5, 2.5, 0}, {4.5, 2.5, 0});
  const BodySnapshot before = snapshot_of(scene);
  scene.bodies.position[1].x = 0.9;
  const auto found = [&](const BodySnapshot* inserted) {
    return record_kernel(KernelName::linked_cell, snapshot_of(scene), scene.domain, {}, {.inserted = inserted}).found;
  };
  CHECK(found(nullptr) == std::vector<Pair>{{0, 1}});
  CHECK(found(&before).empty());
}

TEST_CASE("real threads that race lose only spheres that they have inserted") {
  const RealRace race = race_on_threads(100'000);
  CHECK(race.threads >= 1);
  CHECK(race.lost >= 0);
  CHECK(race.lost < 100'000);
}

TEST_CASE("too many spheres to be stepped through are refused") {
  const Scene scene = make_cloud({.count = 501, .dimensions = 2, .smallest = 0.001, .largest = 0.002}, 1);
  CHECK_THROWS_WITH(record(KernelName::linked_cell, scene), Catch::Contains("at most 500"));
}

TEST_CASE("each kernel has at most 60 lines of code") {
  for (const KernelName kernel : {KernelName::brute_force, KernelName::sort_and_sweep, KernelName::linked_cell}) {
    int code = 0;
    for (const std::string& line : lines_of(kernel)) {
      const size_t start = line.find_first_not_of(' ');
      code += start != std::string::npos && line.compare(start, 2, "//") != 0 && line[start] != '#';
    }
    INFO(name_of(kernel) << ": " << code);
    CHECK(code <= 60);
  }
}
