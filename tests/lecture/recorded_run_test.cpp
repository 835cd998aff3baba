// SPDX-License-Identifier: MIT
// A recorded run of each slide's kernel: its phases, its contacts, and the lines of its source.
#include "lecture/recorded_run.h"

#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>

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
