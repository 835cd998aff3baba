// SPDX-License-Identifier: MIT
#include "tests/support/inputs.h"

#include "tests/support/scenes.h"

namespace ballpit {

namespace {

/// A cloud by its name.
struct Named {
  const char* name;
  Cloud cloud;
};

constexpr Boundary kPeriodic = Boundary::periodic;

const std::vector<Named>& clouds() {
  static const std::vector<Named> all{
      {"sparse", {.count = 400, .smallest = 0.04, .largest = 0.04}},
      {"dense", {.count = 400, .smallest = 0.12, .largest = 0.12}},
      {"clustered", {.count = 300, .smallest = 0.03, .largest = 0.03, .clusters = 4}},
      {"negative and far from the origin",
       {.count = 300, .low = -107.0, .high = -105.0, .smallest = 0.1, .largest = 0.1}},
      {"so far from the origin that floats are coarse",
       {.count = 200, .low = 1e5, .high = 1e5 + 2, .smallest = 0.05, .largest = 0.2}},
      {"far on the negative side, equal radii",
       {.count = 200, .low = -1e5 - 2, .high = -1e5, .smallest = 0.11, .largest = 0.11}},
      {"on cell borders", {.count = 300, .smallest = 0.125, .largest = 0.125, .snap = 0.25}},
      {"touching exactly", {.count = 300, .smallest = 0.0625, .largest = 0.0625, .snap = 0.125}},
      {"all in one cell", {.count = 100, .smallest = 1.5, .largest = 1.5}},
      {"coincident centres", {.count = 200, .smallest = 0.05, .largest = 0.05, .clusters = 12, .scatter = 0}},
      {"coincident centres, radii 1 to 10",
       {.count = 150, .smallest = 0.01, .largest = 0.1, .clusters = 6, .scatter = 0}},
      {"all at one point", {.count = 60, .smallest = 0.05, .largest = 0.05, .clusters = 1, .scatter = 0}},
      {"one plane across each axis", {.count = 200, .smallest = 0.1, .largest = 0.1, .stretch = {1, 1e-9, 1}}},
      {"all intervals on x overlap", {.count = 200, .smallest = 0.1, .largest = 0.1, .stretch = {0.05, 1, 2}}},
      {"a line", {.count = 200, .smallest = 0.02, .largest = 0.02, .stretch = {1e-6, 8, 1e-6}}},

      {"radii 1 to 2", {.count = 300, .smallest = 0.05, .largest = 0.1}},
      {"radii 1 to 20", {.count = 300, .smallest = 0.01, .largest = 0.2}},
      {"radii 1 to 100, as many of each size",
       {.count = 300, .smallest = 0.003, .largest = 0.3, .is_log_uniform = true}},
      {"radii 1 to 1000, as many of each size",
       {.count = 100, .smallest = 8e-4, .largest = 0.8, .is_log_uniform = true}},
      {"radii 1 to 1000, clustered",
       {.count = 100, .smallest = 8e-4, .largest = 0.8, .clusters = 3, .scatter = 0.01, .is_log_uniform = true}},
      {"one huge sphere among small ones", {.count = 300, .smallest = 0.02, .largest = 0.02, .huge = 0.9}},
      {"one sphere a hundred times the size of the rest",
       {.count = 300, .smallest = 0.01, .largest = 0.03, .huge = 3.0}},
      {"radii 1 to 30, snapped",
       {.count = 300, .smallest = 0.01, .largest = 0.3, .snap = 0.125, .is_log_uniform = true}},

      {"open top", {.count = 300, .smallest = 0.1, .largest = 0.1, .boundary = Boundary::open_top}},
      {"beyond an open top",
       {.count = 300, .smallest = 0.2, .largest = 0.2, .boundary = Boundary::open_top, .above = 20}},
      {"far beyond an open top",
       {.count = 200, .smallest = 0.2, .largest = 0.2, .clusters = 20, .boundary = Boundary::open_top, .above = 4000}},
      {"beyond an open top, radii 1 to 50",
       {.count = 300,
        .smallest = 0.01,
        .largest = 0.5,
        .boundary = Boundary::open_top,
        .above = 10,
        .is_log_uniform = true}},

      {"periodic", {.count = 300, .smallest = 0.1, .largest = 0.1, .boundary = kPeriodic}},
      {"periodic, snapped to the border",
       {.count = 300, .smallest = 0.125, .largest = 0.125, .snap = 0.25, .boundary = kPeriodic}},
      {"periodic, radii 1 to 20", {.count = 300, .smallest = 0.01, .largest = 0.2, .boundary = kPeriodic}},
      {"periodic, radii 1 to 300",
       {.count = 80, .smallest = 1.5e-3, .largest = 0.45, .boundary = kPeriodic, .is_log_uniform = true}},
      {"periodic, radii up to the domain's half",
       {.count = 100, .smallest = 0.01, .largest = 1.0, .boundary = kPeriodic, .is_log_uniform = true}},
      {"periodic, three cells", {.count = 200, .smallest = 0.33, .largest = 0.33, .boundary = kPeriodic}},
      {"periodic, two cells", {.count = 100, .smallest = 0.45, .largest = 0.45, .boundary = kPeriodic}},
      {"periodic, one cell", {.count = 50, .smallest = 0.5, .largest = 0.5, .boundary = kPeriodic}},
      {"periodic, spheres wider than the domain",
       {.count = 50, .smallest = 0.1, .largest = 1.4, .boundary = kPeriodic}},
      {"periodic, one, three and many cells",
       {.count = 150, .smallest = 0.15, .largest = 0.15, .boundary = kPeriodic, .stretch = {0.25, 0.5, 2}}},
      {"periodic, two, many and one cells",
       {.count = 150, .smallest = 0.15, .largest = 0.15, .boundary = kPeriodic, .stretch = {0.4, 2, 0.2}}},
      {"periodic, narrow, radii 1 to 10",
       {.count = 150, .smallest = 0.02, .largest = 0.2, .boundary = kPeriodic, .stretch = {2, 0.3, 1}}},
      {"periodic, far from the origin",
       {.count = 200, .low = 1e5, .high = 1e5 + 2, .smallest = 0.1, .largest = 0.1, .boundary = kPeriodic}},
  };
  return all;
}

Scene on_an_axis(Scene scene, int axis) {
  for (Vec3d* p : {&scene.domain.min, &scene.domain.max}) std::swap((*p)[0], (*p)[axis]);
  for (Vec3d& p : scene.bodies.position) std::swap(p[0], p[axis]);
  return scene;
}

}  // namespace

const std::vector<Input>& inputs() {
  static const std::vector<Input> all = [] {
    std::vector<Input> list;
    for (const int dimensions : {3, 2}) {
      for (const Named& named : clouds()) {
        Cloud cloud = named.cloud;
        cloud.dimensions = dimensions;
        const auto make = [cloud](uint64_t seed) {
          // What is special about x is tried along the other axes too, unless only y has an open end.
          const Scene scene = make_cloud(cloud, seed);
          return cloud.boundary == Boundary::open_top ? scene
                                                      : on_an_axis(scene, static_cast<int>(seed) % cloud.dimensions);
        };
        list.push_back({named.name + std::string(dimensions == 2 ? ", planar" : ""), make});
      }
    }
    return list;
  }();
  return all;
}

std::vector<Way> ways(int dimensions) {
  std::vector<Way> list;
  for (const int threads : {1, 2}) {
    list.push_back({.broadphase = "brute-force", .threads = threads});
    list.push_back({.broadphase = "sort-and-sweep", .threads = threads});
    for (const char* method : {"lecture/brute-force", "lecture/sort-and-sweep", "lecture/linked-cell"}) {
      list.push_back({.broadphase = method, .threads = threads});
    }
    for (const char* table : {"dense", "hashed"}) {
      list.push_back({.broadphase = "linked-cell", .table = table, .threads = threads});
      list.push_back({.broadphase = "sorted-grid", .table = table, .threads = threads});
    }
  }
  for (const char* axis : {"x", "y", "z"}) {
    if (axis[0] - 'x' < dimensions) {
      list.push_back({.broadphase = "sort-and-sweep", .axis = axis});
      list.push_back({.broadphase = "lecture/sort-and-sweep", .axis = axis});
    }
  }
  list.push_back({.broadphase = "sorted-grid"});
  list.push_back({.broadphase = "auto"});
  return list;
}

std::vector<Way> ways_with_cell_sizes() {
  std::vector<Way> list;
  for (const char* method : {"linked-cell", "sorted-grid"}) {
    for (const char* table : {"dense", "hashed"}) {
      for (const double size : {1.0, 1.1, 1.5, 2.0, 3.0, 4.0}) {
        list.push_back({.broadphase = method, .table = table, .cell_size = size});
      }
    }
  }
  return list;
}

Settings settings_of(const Way& way) {
  Settings settings;
  settings.broadphase = named<BroadPhase>(way.broadphase);
  settings.table = named<CellTable>(way.table);
  settings.axis = named<SweepAxis>(way.axis);
  settings.threads = way.threads;
  settings.skin = way.skin;
  if (way.cell_size > 0) settings.cell_size = way.cell_size;
  return settings;
}

std::ostream& operator<<(std::ostream& out, const Way& way) {
  return out << way.broadphase << ", table " << way.table << ", axis " << way.axis << ", cell size " << way.cell_size
             << ", threads " << way.threads << ", skin " << way.skin;
}

}  // namespace ballpit
