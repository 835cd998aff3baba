// SPDX-License-Identifier: MIT
#include "broad_phase/grid.h"

#include <set>

#include <catch2/catch.hpp>

#include "core/error.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

template <class V>
Grid<V> unit_cells(const IVec3& cells, bool is_periodic = false) {
  Grid<V> grid;
  grid.edge = grid.inverse_edge = V(1.0f);
  grid.cells = cells;
  grid.is_periodic = is_periodic;
  return grid;
}

template <class V>
Grid<V> hashed(Grid<V> grid, unsigned buckets) {
  grid.is_hashed = true;
  grid.mask = buckets - 1;
  return grid;
}

template <class V>
std::vector<IVec3> neighbours_of(const Grid<V>& grid, const IVec3& center) {
  std::vector<IVec3> cells;
  grid.for_each_neighbour(center, [&](const IVec3& cell) {
    cells.push_back(cell);
    return true;
  });
  return cells;
}

template <class V>
BroadPhaseParameters<V> in_box(const Box<V>& box, float radius, int64_t count) {
  BroadPhaseParameters<V> parameters;
  parameters.box = box;
  parameters.count = count;
  parameters.classes = {{radius, count}};
  return parameters;
}

}  // namespace

TEST_CASE("slide 9: the point (1.5, 1.5) lies in cell 6 of a grid five cells wide") {
  const Grid<Vec2> grid = unit_cells<Vec2>({5, 5, 1});
  CHECK(grid.index(grid.cell_of({1.5f, 1.5f})) == 6);
}

TEST_CASE("points beyond the border of a dense grid count to the cells at the border") {
  const Grid<Vec2> grid = unit_cells<Vec2>({5, 4, 1});
  CHECK(grid.cell_of({-0.1f, 100.0f}) == IVec3(0, 3, 0));
  CHECK(grid.cell_of({5.0f, -1e30f}) == IVec3(4, 0, 0));
  CHECK(grid.cell_of({1e30f, 3.999f}) == IVec3(4, 3, 0));
}

TEST_CASE("a hashed grid has cells on all sides of the domain, and beyond the farthest no others") {
  const Grid<Vec2> grid = hashed(unit_cells<Vec2>({5, 4, 1}), 16);
  CHECK(grid.cell_of({-0.1f, 100.5f}) == IVec3(-1, 100, 0));
  CHECK(grid.cell_of({-1.0f, -1.5f}) == IVec3(-1, -2, 0));
  CHECK(grid.cell_of({1e30f, -1e30f}) == IVec3(2048, -2048, 0));
}

TEST_CASE("the block around a cell has 27 cells inside, fewer at the border, each once") {
  const Grid<Vec3> grid = unit_cells<Vec3>({4, 5, 6});
  CHECK(neighbours_of(grid, {1, 1, 1}).size() == 27);
  CHECK(neighbours_of(grid, {0, 0, 0}).size() == 8);
  CHECK(neighbours_of(grid, {3, 2, 5}).size() == 12);
  CHECK(neighbours_of(unit_cells<Vec2>({4, 5, 1}), {1, 1, 0}).size() == 9);
  CHECK(neighbours_of(unit_cells<Vec2>({1, 1, 1}), {0, 0, 0}).size() == 1);
  CHECK(neighbours_of(hashed(grid, 64), {0, 0, 0}).size() == 27);
}

TEST_CASE("in a periodic grid the block wraps around, and has each cell once, however few there are") {
  for (int n = 1; n <= 5; ++n) {
    for (const bool is_hashed : {false, true}) {
      Grid<Vec2> grid = unit_cells<Vec2>({n, 5, 1}, true);
      if (is_hashed) grid = hashed(grid, 8);
      for (int x = 0; x < n; ++x) {
        std::set<std::pair<int, int>> seen;
        for (const IVec3& cell : neighbours_of(grid, {x, 4, 0})) {
          CHECK((cell.x >= 0 && cell.x < n && cell.y >= 0 && cell.y < 5));
          CHECK(seen.emplace(cell.x, cell.y).second);
        }
        CHECK(seen.size() == static_cast<size_t>(std::min(n, 3) * 3));
        CHECK(seen.count({(x + 1) % n, 0}) == 1);
      }
    }
  }
}

TEST_CASE("a block is left where the visitor asks for it") {
  int visits = 0;
  unit_cells<Vec3>({4, 4, 4}).for_each_neighbour({1, 1, 1}, [&](const IVec3&) { return ++visits < 5; });
  CHECK(visits == 5);
}

TEST_CASE("cells that are neighbours along x have neighbouring buckets") {
  for (const unsigned buckets : {0u, 4u, 64u}) {
    Grid<Vec3> grid = unit_cells<Vec3>({10, 10, 10});
    if (buckets > 0) grid = hashed(grid, buckets);
    for (int k = 0; k < 100; ++k) {
      const IVec3 cell(k % 9, k / 10, (k * 7) % 10);
      const int64_t at = grid.index(cell), next = grid.index(cell + IVec3(1, 0, 0));
      CHECK(next == (at + 1) % grid.size());
      CHECK((at >= 0 && at < grid.size()));
    }
  }
}

TEST_CASE("cells of one block differ in bucket or in tag, however few buckets there are") {
  // In an unbounded hashed grid tags tell rows apart, in a periodic one cells.
  for (const unsigned buckets : {4u, 8u, 16u, 64u}) {
    for (const int wrap : {0, 3, 4, 7}) {
      const bool is_periodic = wrap > 0;
      const Grid<Vec3> grid = hashed(unit_cells<Vec3>({wrap, wrap, wrap}, is_periodic), buckets);
      Random random(buckets);
      for (int k = 0; k < 200; ++k) {
        const int reach = is_periodic ? wrap : 40000;
        const auto coordinate = [&] {
          return static_cast<int>(random.bits() % unsigned(reach)) - (is_periodic ? 0 : reach / 2);
        };
        const IVec3 center(coordinate(), coordinate(), coordinate());
        std::set<std::pair<int, unsigned>> seen;
        for (const IVec3& cell : neighbours_of(grid, center))
          REQUIRE(seen.emplace(grid.index(cell), grid.tag(cell)).second);
        REQUIRE(seen.size() == 27);
      }
    }
  }
}

TEST_CASE("hashing spreads rows over the buckets") {
  const Grid<Vec3> grid = hashed(unit_cells<Vec3>({100, 100, 100}), 1024);
  std::vector<int> uses(1024, 0);
  for (int z = 0; z < 64; ++z) {
    for (int y = 0; y < 64; ++y) ++uses[static_cast<size_t>(grid.index({0, y, z}))];
  }
  // 4096 rows in 1024 buckets, 4 each: by chance, one bucket in a thousand has more than 11, and one in fifty has none.
  CHECK(*std::max_element(uses.begin(), uses.end()) < 20);
  CHECK(std::count(uses.begin(), uses.end(), 0) < 60);
}

TEST_CASE("centres of spheres that touch lie in neighbouring cells, rounding included") {
  Random random(6);
  for (int k = 0; k < 3000; ++k) {
    const float low = static_cast<float>(random.uniform(-1000, 1000)),
                size = static_cast<float>(random.uniform(0.5, 20));
    const float radius = static_cast<float>(size * random.uniform(0.01, 0.2));
    const Boundary boundary = k % 3 == 0 ? Boundary::periodic : (k % 3 == 1 ? Boundary::walls : Boundary::open_top);
    const Box<Vec2> box{Vec2(low), Vec2(low + size), boundary};
    auto parameters = in_box(box, radius, 50);
    if (k % 2 == 0) parameters.cell_size = 1.0;
    for (const bool is_hashed : {false, true}) {
      const Grid<Vec2> grid = make_grid(parameters, parameters.classes[0], Vec2(2 * radius), is_hashed);
      for (int pair = 0; pair < 20; ++pair) {
        const Vec3d direction = random.direction(2);
        const Vec2 a = box.wrap(Vec2(low + size * random.uniform(), low + size * random.uniform()));
        const Vec2 b = box.wrap(a + 2 * radius * (pair % 2 == 0 ? Vec2(1, 0) : Vec2(direction.x, direction.y)));
        if (!box.holds(b) || !in_contact(box.displacement(a, b), 2 * radius)) continue;
        const auto block = neighbours_of(grid, grid.cell_of(a));
        REQUIRE(std::count(block.begin(), block.end(), grid.cell_of(b)) == 1);
      }
    }
  }
}

TEST_CASE("spheres that touch are in neighbouring cells of a hashed grid, however far from the domain") {
  Random random(9);
  for (int k = 0; k < 50; ++k) {
    const float diameter = static_cast<float>(random.uniform(0.02, 0.4));
    const Box<Vec2> box{Vec2(0.1f), Vec2(0.6f), Boundary::open_top};
    const auto parameters = in_box(box, diameter / 2, 100);
    const Grid<Vec2> grid = make_grid(parameters, parameters.classes[0], Vec2(diameter), true);
    bool are_neighbours = true;
    for (int cell = 1; cell < 300000; cell += cell < 3000 ? 1 : 997) {
      // The last float that lies below a cell's border, and the farthest that is one diameter from it.
      float a = grid.origin.y + static_cast<float>(cell) * grid.edge.y;
      while (grid.coordinate_of(a, 1) >= cell) a = std::nextafter(a, 0.0f);
      for (int up = 0; up < 8 && grid.coordinate_of(std::nextafter(a, 1e9f), 1) < cell; ++up)
        a = std::nextafter(a, 1e9f);
      float b = a + diameter;
      while (b - a > diameter) b = std::nextafter(b, 0.0f);
      are_neighbours &= grid.coordinate_of(b, 1) - grid.coordinate_of(a, 1) <= 1;
    }
    REQUIRE(are_neighbours);
  }
}

TEST_CASE("a dense grid has a bounded number of cells for each sphere, a hashed one for all") {
  for (const Boundary boundary : {Boundary::walls, Boundary::periodic}) {
    const auto parameters = in_box(Box<Vec3>{Vec3(0.0f), Vec3(100.0f), boundary}, 0.1f, 1000);
    CHECK(make_grid(parameters, parameters.classes[0], Vec3(0.2f), false).size() < 40000);
    CHECK(make_grid(parameters, parameters.classes[0], Vec3(0.2f), true).size() == 2048);
  }
}

TEST_CASE("cells have the edges that are asked for, or those of the cell size") {
  auto parameters = in_box(Box<Vec3>{Vec3(0.0f), Vec3(10.0f), Boundary::walls}, 0.5f, 100);
  const auto edge_is = [&](const Vec3& expected) {
    const Vec3 edge = make_grid(parameters, parameters.classes[0], Vec3(1.0f, 2.5f, 3.0f), false).edge;
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(edge[axis] >= expected[axis]);
      CHECK(edge[axis] == Approx(expected[axis]).epsilon(1e-4));
    }
  };
  edge_is(Vec3(1.0f, 2.5f, 3.0f));
  parameters.cell_size = 0.5;
  edge_is(Vec3(0.5f));
}

TEST_CASE("cells of a periodic domain fit into it a whole number of times") {
  const Box<Vec3> box{Vec3(-1.0f), Vec3(0.0f, 1.5f, 9.0f), Boundary::periodic};
  const auto parameters = in_box(box, 0.2f, 1000);
  const Grid<Vec3> grid = make_grid(parameters, parameters.classes[0], Vec3(0.4f), false);
  CHECK(grid.cells == IVec3(2, 6, 24));
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(grid.edge[axis] * static_cast<float>(grid.cells[axis]) == Approx(box.max[axis] - box.min[axis]));
    CHECK(grid.edge[axis] >= 0.4f);
  }
}

TEST_CASE("a cell size that needs more cells than an index holds is refused with the number, unless hashed") {
  Scene scene;
  scene.domain.max = Vec3d(1000.0);
  add_sphere(scene, Vec3d(1.0), Vec3d(0.0), 0.01);
  for (const char* const method : {"linked-cell", "sorted-grid"}) {
    Settings settings = settings_of({.broadphase = method, .cell_size = 1.0});
    CHECK_THROWS_WITH(make_cpu_world(scene, settings), Catch::Contains("--cell-size: found 1") &&
                                                           Catch::Contains("cells") &&
                                                           Catch::Contains("--table hashed"));
    CHECK_THROWS_AS(make_cpu_world(scene, settings), UserError);
    settings = settings_of({.broadphase = method, .table = "hashed", .cell_size = 1.0});
    CHECK(make_cpu_world(scene, settings)->inspect().contacts.empty());
  }
}

TEST_CASE("a border surrounds the cells of a grid without changing who shares one") {
  const Grid<Vec2> grid = unit_cells<Vec2>({5, 4, 1}), bordered = with_border(grid);
  CHECK(bordered.cells.x == 7);
  CHECK(bordered.cells.y == 6);
  for (const Vec2 p : {Vec2(0.5f, 0.5f), Vec2(-3.0f, 2.5f), Vec2(4.9f, 3.9f), Vec2(9.0f, 9.0f)}) {
    CHECK(bordered.cell_of(p) == grid.cell_of(p) + IVec3(1, 1, 0));
  }
  const GridInspection seen = describe_grid(bordered);
  CHECK(seen.cells == IVec3(5, 4, 1));
  CHECK(seen.origin == Vec3(0.0f));
  CHECK(seen.edge == Vec3(1.0f, 1.0f, 0.0f));
}

TEST_CASE("cells are listed for the audience, bodies beyond the border at the border, unless they are too many") {
  const std::vector<Vec2> position{{0.5f, 0.5f}, {0.6f, 0.6f}, {4.5f, 3.5f}, {-2.0f, 9.0f}, {0.7f, 0.7f}};
  for (const Grid<Vec2>& grid : {unit_cells<Vec2>({5, 4, 1}), with_border(unit_cells<Vec2>({5, 4, 1})),
                                 hashed(unit_cells<Vec2>({5, 4, 1}), 4)}) {
    const auto seen = list_cells(grid, position, {0, 1, 2, 3});
    std::vector<int32_t> head(20, -1);
    head[0] = 1;
    head[19] = 2;
    head[15] = 3;
    CHECK(seen.head == head);
    CHECK(seen.next == std::vector<int32_t>{-1, 0, -1, -1, -1});
  }
  const GridInspection vast = list_cells(unit_cells<Vec2>({1 << 15, 1 << 15, 1}), position, {0});
  CHECK(vast.cells == IVec3(1 << 15, 1 << 15, 1));
  CHECK(vast.head.empty());
  CHECK(vast.next.empty());
}
