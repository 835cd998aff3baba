// SPDX-License-Identifier: MIT
#include "world/spatial_order.h"

#include <algorithm>
#include <numeric>
#include <string_view>

#include <catch2/catch.hpp>

#include "exec/cpu_executor.h"
#include "tests/support/body_arrays.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

constexpr int kBodies = 5000;

template <class T>
HostBuffer<T> buffer_of(CpuExecutor& exec, const std::vector<T>& values) {
  HostBuffer<T> buffer;
  exec.upload(buffer, values);
  return buffer;
}

/// Positions kept in a spatial order.
struct Ordered {
  CpuExecutor exec;
  HostBuffer<Vec3> position, scratch;
  SpatialOrder<Vec3, CpuExecutor> order;

  Ordered(const BodyArrays<Vec3>& bodies, int threads)
      : exec(threads), position(buffer_of(exec, bodies.position)), order(bodies.box, bodies.count()) {}

  void sort() {
    order.sort(exec, position.span());
    order.rearrange(exec, position, scratch);
    order.commit(exec);
  }
  std::vector<int> id_at() { return exec.download(order.id_at()); }
  std::vector<Vec3> kept() { return exec.download(position.span()); }
};

/// A world of so many spheres that it keeps them sorted.
Scene large_scene(Cloud cloud) {
  cloud.count = kBodies;
  return make_cloud(cloud, 12);
}

}  // namespace

TEST_CASE("bodies are kept in the order of cells, each once, and known by id") {
  const BodyArrays<Vec3> bodies(large_scene({.smallest = 0.05, .largest = 0.05}));
  Ordered ordered(bodies, 2);
  CHECK(ordered.id_at().empty());
  ordered.sort();
  std::vector<int> id_at = ordered.id_at();
  const std::vector<Vec3> kept = ordered.kept();
  for (int place = 0; place < kBodies; ++place)
    REQUIRE(kept[place] == bodies.position[static_cast<size_t>(id_at[place])]);
  double far = 0, far_before = 0;
  for (size_t k = 1; k < kBodies; ++k) {
    far += length(kept[k] - kept[k - 1]);
    far_before += length(bodies.position[k] - bodies.position[k - 1]);
  }
  CHECK(far < far_before / 4);  // neighbours in memory are nearer
  std::sort(id_at.begin(), id_at.end());
  std::vector<int> all(kBodies);
  std::iota(all.begin(), all.end(), 0);
  CHECK(id_at == all);
}

TEST_CASE("the order follows from positions and ids alone, not from earlier orders or threads") {
  const BodyArrays<Vec3> before(large_scene({.smallest = 0.05, .largest = 0.05}));
  BodyArrays<Vec3> after = before;
  Random random(3);
  for (Vec3& p : after.position) p = Vec3(random.uniform(Vec3d(-1.0), Vec3d(1.0)));
  after.position[7] = after.position[4000] = after.position[100];  // equal keys: the order of ids

  Ordered twice(before, 8), once(after, 1);
  twice.sort();
  const std::vector<int> first = twice.id_at();
  std::vector<Vec3> moved(kBodies);
  for (size_t place = 0; place < kBodies; ++place) moved[place] = after.position[static_cast<size_t>(first[place])];
  twice.exec.upload(twice.position, moved);
  twice.sort();
  once.sort();
  CHECK((first != once.id_at()));
  CHECK((twice.id_at() == once.id_at()));
  CHECK((twice.kept() == once.kept()));
}

TEST_CASE("small scenes keep the scene's order, large ones are sorted every 64 steps") {
  const Box<Vec3> box{Vec3(0.0f), Vec3(1.0f), Boundary::walls};
  const SpatialOrder<Vec3, CpuExecutor> small(box, 4095), large(box, 4096);
  for (int64_t step = 0; step < 200; ++step) {
    CHECK_FALSE(small.is_due(step));
    CHECK(large.is_due(step) == (step % 64 == 0));
  }
}

TEST_CASE("one value for all bodies is left alone") {
  const BodyArrays<Vec3> bodies(large_scene({.smallest = 0.05, .largest = 0.05}));
  Ordered ordered(bodies, 1);
  ordered.order.sort(ordered.exec, ordered.position.span());
  HostBuffer<float> one = buffer_of(ordered.exec, std::vector<float>{0.5f}), scratch;
  ordered.order.rearrange(ordered.exec, one, scratch);
  CHECK(one.size() == 1);
  CHECK(one.span()[0] == 0.5f);
}

TEST_CASE("an inspection is put from places to ids") {
  // Places 0, 1, 2 hold the bodies 2, 0, 1; the cell's list leads from place 2 to place 0.
  Inspection inspection;
  inspection.contacts = {{0, 1}, {1, 2}};
  inspection.grids.resize(1);
  inspection.grids[0].head = {2, -1};
  inspection.grids[0].next = {-1, -1, 0};
  name_by_id(inspection, {2, 0, 1});
  CHECK(inspection.contacts == std::vector<Pair>{{0, 1}, {0, 2}});
  CHECK(inspection.grids[0].head == std::vector<int32_t>{1, -1});
  CHECK(inspection.grids[0].next == std::vector<int32_t>{-1, 2, -1});
}

TEST_CASE("worlds that sorted their bodies show them and their contacts by id") {
  const Cloud cloud = GENERATE(Cloud{.smallest = 0.03, .largest = 0.03}, Cloud{.smallest = 0.01, .largest = 0.08},
                               Cloud{.dimensions = 2, .smallest = 0.01, .largest = 0.02},
                               Cloud{.smallest = 0.03, .largest = 0.03, .boundary = Boundary::periodic});
  const Scene scene = large_scene(cloud);
  Scene now = scene;
  std::vector<Pair> expected;
  for (const Way& way :
       {Way{.broadphase = "brute-force"}, Way{.broadphase = "sort-and-sweep", .threads = 2, .skin = 0.1},
        Way{.broadphase = "linked-cell", .threads = 2},
        Way{.broadphase = "linked-cell", .table = "hashed", .skin = 0.1},
        Way{.broadphase = "sorted-grid", .threads = 2},
        Way{.broadphase = "sorted-grid", .table = "hashed", .skin = 0.1}}) {
    INFO(way << ", dimensions " << cloud.dimensions);
    Settings settings = settings_of(way);
    settings.dt = 1e-5;  // nothing moves far: who is who can be told by position
    const auto world = make_cpu_world(scene, settings);
    world->step();
    world->step();
    const std::vector<Stage> stages = world->report().stages;
    REQUIRE(std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.name == "sort bodies"; }));
    if (expected.empty()) {
      now.bodies = world->bodies();
      expected = pairs_by_definition(now);
      REQUIRE(expected.size() > 1000);
    }
    const Inspection seen = world->inspect();
    CHECK(difference(seen.contacts, expected) == "");
    for (int i = 0; i < kBodies; ++i) {
      const auto k = static_cast<size_t>(i);
      const Vec3 p(now.bodies.position[k]), start(scene.bodies.position[k]);
      REQUIRE(seen.bodies.position_of(i) == p);
      REQUIRE(seen.bodies.velocity_of(i) == Vec3(now.bodies.velocity[k]));
      REQUIRE(seen.bodies.radius_of(i) == float(scene.bodies.radius[k]));
      REQUIRE((cloud.boundary == Boundary::periodic || length(p - start) < 0.1f));
    }
  }
}

/// The arrays that a method has of its own: each body in one list or range; of cells, in that of its own.
void check_arrays(const Inspection& seen, bool is_sorted, bool is_hashed) {
  std::vector<int> times(static_cast<size_t>(seen.bodies.count), 0);
  for (const GridInspection& grid : seen.grids) {
    REQUIRE(grid.arrays.has_value() == (is_sorted || is_hashed));  // else they are head and next
    if (!grid.arrays) return;
    const CellArrays& arrays = *grid.arrays;
    CHECK(arrays.is_sorted == is_sorted);
    if (!is_sorted) CHECK(arrays.is_hashed);
    const size_t entries = arrays.cells.size() - is_sorted;
    if (!arrays.is_hashed) REQUIRE(entries == grid.head.size());
    for (size_t entry = 0; entry < entries; ++entry) {
      std::vector<int> bodies;
      if (is_sorted) {
        for (int slot = arrays.cells[entry]; slot < arrays.cells[entry + 1]; ++slot)
          bodies.push_back(arrays.bodies.at(static_cast<size_t>(slot)));
      } else {
        for (int i = arrays.cells[entry]; i >= 0; i = arrays.bodies.at(static_cast<size_t>(i))) bodies.push_back(i);
      }
      for (const int body : bodies) ++times.at(static_cast<size_t>(body));
      if (arrays.is_hashed) continue;
      std::vector<int> listed;
      for (int i = grid.head[entry]; i >= 0; i = grid.next[static_cast<size_t>(i)]) listed.push_back(i);
      std::reverse(listed.begin(), listed.end());
      REQUIRE(bodies == listed);
    }
  }
  CHECK(std::count(times.begin(), times.end(), 1) == seen.bodies.count);
}

TEST_CASE(
    "each body is in the list of the cell that its centre lies in, and in no other, also in worlds that sorted them") {
  for (const int count : {500, kBodies}) {
    for (const Cloud& cloud : {Cloud{.smallest = 0.03, .largest = 0.03}, Cloud{.smallest = 0.01, .largest = 0.08},
                               Cloud{.dimensions = 2, .smallest = 0.01, .largest = 0.02},
                               Cloud{.smallest = 0.03, .largest = 0.03, .boundary = Boundary::periodic}}) {
      for (const char* const method : {"linked-cell", "sorted-grid"}) {
        for (const char* const table : {"dense", "hashed"}) {
          Cloud sized = cloud;
          sized.count = count;
          Settings settings =
              settings_of({.broadphase = method, .table = table, .threads = 2, .skin = count % 3 * 0.1});
          settings.dt = 1e-5;
          const auto world = make_cpu_world(make_cloud(sized, 4), settings);
          world->step();
          const Inspection seen = world->inspect();
          INFO(method << ", " << table << ", " << count << ", dimensions " << cloud.dimensions);
          REQUIRE_FALSE(seen.grids.empty());
          std::vector<int> times(static_cast<size_t>(count), 0);
          for (const GridInspection& grid : seen.grids) {
            REQUIRE(grid.next.size() == static_cast<size_t>(count));
            REQUIRE(grid.head.size() == static_cast<size_t>(grid.cells.x) * grid.cells.y * grid.cells.z);
            for (int64_t c = 0; c < static_cast<int64_t>(grid.head.size()); ++c) {
              const IVec3 cell(c % grid.cells.x, c / grid.cells.x % grid.cells.y, c / grid.cells.x / grid.cells.y);
              for (int i = grid.head[static_cast<size_t>(c)]; i != -1; i = grid.next[static_cast<size_t>(i)]) {
                REQUIRE(++times[static_cast<size_t>(i)] == 1);
                const Vec3 inside = (seen.bodies.position_of(i) - grid.origin) - Vec3(cell) * grid.edge;
                for (int axis = 0; axis < cloud.dimensions; ++axis) {
                  REQUIRE(inside[axis] > -1e-5f);
                  REQUIRE(inside[axis] < grid.edge[axis] + 1e-5f);
                }
              }
            }
          }
          CHECK(std::count(times.begin(), times.end(), 1) == count);
          check_arrays(seen, std::string_view(method) == "sorted-grid", std::string_view(table) == "hashed");
        }
      }
    }
  }
}
