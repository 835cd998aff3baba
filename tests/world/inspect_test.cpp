// SPDX-License-Identifier: MIT
// What a world shows of itself only where it is wanted, and that showing it changes nothing.
#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include <catch2/catch.hpp>

#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

constexpr Wanted kAll{true, true, true, true, true};
constexpr int kCount = 250;

const std::vector<Cloud>& clouds() {
  static const std::vector<Cloud> all{
      {.count = kCount, .smallest = 0.1, .largest = 0.1},
      {.count = kCount, .smallest = 0.02, .largest = 0.2, .is_log_uniform = true},
      {.count = kCount, .dimensions = 2, .smallest = 0.03, .largest = 0.06},
      {.count = kCount, .smallest = 0.1, .largest = 0.1, .boundary = Boundary::periodic},
      {.count = kCount, .dimensions = 2, .smallest = 0.05, .largest = 0.05, .boundary = Boundary::periodic},
      {.count = kCount, .smallest = 0.1, .largest = 0.4, .boundary = Boundary::periodic, .stretch = {0.6, 1, 0.5}}};
  return all;
}

/// The methods with cells, and without.
const std::vector<Way>& inspected_methods() {
  static const std::vector<Way> all{{.broadphase = "brute-force"},
                                    {.broadphase = "sort-and-sweep"},
                                    {.broadphase = "linked-cell", .table = "dense"},
                                    {.broadphase = "linked-cell", .table = "hashed", .threads = 2},
                                    {.broadphase = "sorted-grid", .table = "dense", .threads = 2},
                                    {.broadphase = "sorted-grid", .table = "hashed"}};
  return all;
}

Inspection seen_in(const Scene& scene, const Way& way) {
  return make_cpu_world(scene, settings_of(way))->inspect(kAll);
}

/// Whether pairs of so many bodies are in canonical order, each once, lower body first.
bool is_list(const std::vector<Pair>& pairs, int count) {
  return std::is_sorted(pairs.begin(), pairs.end()) && std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end() &&
         std::all_of(pairs.begin(), pairs.end(),
                     [&](const Pair& pair) { return 0 <= pair.i && pair.i < pair.j && pair.j < count; });
}

bool holds_all(const std::vector<Pair>& pairs, const std::vector<Pair>& some) {
  return std::includes(pairs.begin(), pairs.end(), some.begin(), some.end());
}

std::vector<float> places_of(const std::vector<Endpoint>& endpoints) {
  std::vector<float> at;
  for (const Endpoint& endpoint : endpoints) at.push_back(endpoint.at);
  return at;
}

/// "b0 b2 e0"
std::string names_of(const std::vector<Endpoint>& endpoints) {
  std::string names;
  for (const Endpoint& endpoint : endpoints) {
    names += (names.empty() ? "" : " ") + std::string(endpoint.is_end ? "e" : "b") + std::to_string(endpoint.body);
  }
  return names;
}

/// Whether each sphere begins and ends once, where it does along the axis, and the list is sorted.
void check_endpoints(const Inspection& seen) {
  REQUIRE(int64_t(seen.endpoints.size()) == 2 * seen.bodies.count);
  std::vector<int> begins(seen.endpoints.size() / 2, 0), ends = begins;
  for (const Endpoint& endpoint : seen.endpoints) {
    ++(endpoint.is_end ? ends : begins)[size_t(endpoint.body)];
    const float radius = seen.bodies.radius_of(endpoint.body);
    const float expected = seen.bodies.position_of(endpoint.body)[seen.axis] + (endpoint.is_end ? radius : -radius);
    REQUIRE(std::abs(endpoint.at - expected) < 1e-5f);
  }
  CHECK(begins == std::vector<int>(begins.size(), 1));
  CHECK(ends == begins);
  const std::vector<float> at = places_of(seen.endpoints);
  CHECK(std::is_sorted(at.begin(), at.end()));
}

/// What may be told of reports that look at the same.
std::vector<std::pair<std::string, int64_t>> counts_of(const Report& report) {
  std::vector<std::pair<std::string, int64_t>> counts{{"candidates", report.candidates},
                                                      {"contacts", report.contacts},
                                                      {"searches", report.searches},
                                                      {"detection bytes", report.detection_bytes},
                                                      {"motion bytes", report.motion_bytes}};
  for (const Stage& stage : report.stages) counts.emplace_back(stage.name, stage.launches);
  return counts;
}

/// What the threads of each body walk.
std::vector<int> work_of(const Inspection& seen) {
  std::vector<int> work(static_cast<size_t>(seen.bodies.count), 0);
  for (size_t t = 0; t < seen.work.size(); ++t) {
    if (seen.worker[t] >= 0) work[static_cast<size_t>(seen.worker[t])] += seen.work[t];
  }
  return work;
}

/// Pairs of bodies in cells that are neighbours, as an inspected grid lists them, in a domain with walls.
std::vector<Pair> pairs_in_neighbouring_cells(const GridInspection& grid, int count) {
  std::vector<IVec3> cell(static_cast<size_t>(count));
  for (int c = 0; c < static_cast<int>(grid.head.size()); ++c) {
    for (int i = grid.head[size_t(c)]; i >= 0; i = grid.next[size_t(i)]) {
      cell[size_t(i)] = {c % grid.cells.x, c / grid.cells.x % grid.cells.y, c / grid.cells.x / grid.cells.y};
    }
  }
  std::vector<Pair> pairs;
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      const IVec3 d = glm::abs(cell[size_t(i)] - cell[size_t(j)]);
      if (std::max({d.x, d.y, d.z}) <= 1) pairs.push_back({i, j});
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("candidates are listed once and sorted, hold every contact, and are as many as the report counts") {
  for (const Cloud& cloud : clouds()) {
    const Scene scene = make_cloud(cloud, 21);
    for (const Way& way : ways(cloud.dimensions)) {
      INFO(way << ", dimensions " << cloud.dimensions << ", largest " << cloud.largest);
      const auto world = make_cpu_world(scene, settings_of(way));
      const Inspection seen = world->inspect(kAll);
      REQUIRE(is_list(seen.candidates, kCount));
      REQUIRE(holds_all(seen.candidates, seen.contacts));
      REQUIRE(seen.missed.empty());
      const Report report = world->report();
      if (report.broadphase == "sorted-grid" && way.table != "dense") {
        REQUIRE(int64_t(seen.candidates.size()) <= report.candidates);  // it counts strangers in shared places as well
      } else {
        REQUIRE(int64_t(seen.candidates.size()) == report.candidates);
      }
    }
  }
}

TEST_CASE("brute force has all pairs as candidates") {
  const Inspection seen = seen_in(make_cloud({.count = 40}, 1), {.broadphase = "brute-force"});
  CHECK(seen.candidates.size() == 40 * 39 / 2);
  CHECK(is_list(seen.candidates, 40));
}

TEST_CASE("candidates of each method on four spheres are those named by hand, with a skin or without") {
  //   y │ ·  2  ·  ·      0 and 1 share a cell, 2 lies diagonally above them, 3 three cells to the right
  //     │ 01 ·  ·  3      cells are one diameter wide, 1 m
  //     └─────────── x
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(4.0, 4.0, 0.0), Boundary::walls, 2};
  for (const Vec3d& p : {Vec3d(0.5, 0.5, 0), Vec3d(0.9, 0.5, 0), Vec3d(1.6, 1.6, 0), Vec3d(3.5, 0.5, 0)}) {
    add_sphere(scene, p, Vec3d(0.0), 0.5);
  }
  using Pairs = std::vector<Pair>;
  for (const double skin : {0.0, 0.5}) {
    const auto candidates = [&](Way way) {
      way.skin = skin;
      return seen_in(scene, way).candidates;
    };
    CHECK(candidates({.broadphase = "brute-force"}) == Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}});
    CHECK(candidates({.broadphase = "sort-and-sweep", .axis = "x"}) == Pairs{{0, 1}, {1, 2}});
    CHECK(candidates({.broadphase = "sort-and-sweep", .axis = "y"}) == Pairs{{0, 1}, {0, 3}, {1, 3}});
    for (const char* const method : {"linked-cell", "sorted-grid"}) {
      for (const char* const table : {"dense", "hashed"}) {
        INFO(method << ", " << table << ", skin " << skin);
        CHECK(candidates({.broadphase = method, .table = table, .cell_size = 1}) == Pairs{{0, 1}, {0, 2}, {1, 2}});
      }
    }
  }
}

TEST_CASE("pairs that cells of half a diameter miss are listed, and cells of one diameter miss none") {
  for (const Cloud& cloud : clouds()) {
    const Scene scene = make_cloud(cloud, 22);
    const std::vector<Pair> all = pairs_by_definition(scene);
    for (const char* const method : {"linked-cell", "sorted-grid"}) {
      for (const char* const table : {"dense", "hashed"}) {
        INFO(method << ", " << table << ", dimensions " << cloud.dimensions << ", largest " << cloud.largest);
        Inspection seen = seen_in(scene, {.broadphase = method, .table = table, .cell_size = 0.5});
        REQUIRE(is_list(seen.missed, kCount));
        CHECK(holds_all(seen.candidates, seen.contacts));
        std::vector<Pair> both;
        std::merge(seen.contacts.begin(), seen.contacts.end(), seen.missed.begin(), seen.missed.end(),
                   std::back_inserter(both));
        CHECK(difference(both, all) == "");
        if (cloud.smallest == cloud.largest) CHECK(seen.missed.size() > 10);
        seen = seen_in(scene, {.broadphase = method, .table = table, .cell_size = 1});
        CHECK(seen.missed.empty());
      }
    }
  }
}

TEST_CASE("sort and sweep shows the list of slide 3") {
  //     b0 ────────── e0
  //           b2 ───────────── e2
  //                      b1 ───────── e1
  Scene scene;
  scene.domain = {Vec3d(0.0), Vec3d(8.0, 8.0, 0.0), Boundary::walls, 2};
  add_sphere(scene, {2, 2, 0}, Vec3d(0.0), 1);
  add_sphere(scene, {5, 2, 0}, Vec3d(0.0), 1);
  add_sphere(scene, {3.5, 5, 0}, Vec3d(0.0), 1.5);
  const Inspection seen = seen_in(scene, {.broadphase = "sort-and-sweep", .axis = "x"});
  CHECK(seen.axis == 0);
  CHECK(names_of(seen.endpoints) == "b0 b2 e0 b1 e2 e1");
  const std::vector<float> expected{1, 2, 3, 4, 5, 6};
  for (size_t p = 0; p < 6; ++p) CHECK(seen.endpoints[p].at == Approx(expected[p]));
  CHECK(seen.work == std::vector<int>{1, 1, 0});  // a thread for each begin tests the begins up to its end
  CHECK(seen.worker == std::vector<int32_t>{0, 2, 1});
  const Inspection on_slides = seen_in(scene, {.broadphase = "lecture/sort-and-sweep", .axis = "x"});
  CHECK(on_slides.axis == 0);
  CHECK(names_of(on_slides.endpoints) == "b0 b2 e0 b1 e2 e1");
  CHECK(on_slides.work == std::vector<int>{2, 3, 0, 2, 0, 0});  // a thread for each entry walks the list
  CHECK(on_slides.worker == std::vector<int32_t>{0, 2, -1, 1, -1, -1});
  CHECK(seen_in(scene, {.broadphase = "sort-and-sweep", .axis = "y"}).axis == 1);
  CHECK(seen_in(scene, {.broadphase = "linked-cell"}).axis == -1);
  CHECK(seen_in(scene, {.broadphase = "linked-cell"}).endpoints.empty());
}

TEST_CASE("a sphere begins before another ends where they touch exactly") {
  Scene scene;
  for (const double x : {0.75, 0.5, 0.25}) add_sphere(scene, {x, 0.5, 0.5}, Vec3d(0.0), 0.125);
  const Inspection seen = seen_in(scene, {.broadphase = "sort-and-sweep"});
  CHECK(seen.axis == 0);
  CHECK(names_of(seen.endpoints) == "b2 b1 e2 b0 e1 e0");
  CHECK(seen.candidates == std::vector<Pair>{{0, 1}, {1, 2}});
}

TEST_CASE("each sphere begins and ends once in the sorted list, a radius before its centre and behind it") {
  for (const Cloud& cloud : clouds()) {
    const Scene scene = make_cloud(cloud, 23);
    for (const char* const axis : {"auto", "x", "y"}) {
      for (const char* const precision : {"float", "double"}) {
        INFO("axis " << axis << ", dimensions " << cloud.dimensions << ", " << precision);
        Settings settings = settings_of({.broadphase = "sort-and-sweep", .axis = axis, .threads = 2});
        settings.precision = named<Precision>(precision);
        const Inspection seen = make_cpu_world(scene, settings)->inspect(kAll);
        if (axis != std::string("auto")) CHECK(seen.axis == axis[0] - 'x');
        check_endpoints(seen);
      }
    }
  }
}

TEST_CASE("the work of all threads adds up to the candidates, except where threads walk lists") {
  const Scene scene = make_cloud({.count = 200, .smallest = 0.1, .largest = 0.1}, 24);
  for (const Way& way : inspected_methods()) {
    if (way.broadphase.starts_with("lecture/")) continue;
    INFO(way);
    const auto world = make_cpu_world(scene, settings_of(way));
    const std::vector<int> work = world->inspect(kAll).work;
    CHECK(work.size() == 200);
    CHECK(std::accumulate(work.begin(), work.end(), int64_t{0}) == world->report().candidates);
  }
  CHECK(seen_in(make_cloud({.count = 5}, 1), {.broadphase = "brute-force"}).work == std::vector<int>{4, 3, 2, 1, 0});
}

TEST_CASE("each body has one thread that walks for it, and meets what the body is a candidate with") {
  const Scene scene = make_cloud({.count = 200, .smallest = 0.1, .largest = 0.1}, 24);
  for (const Way& way : inspected_methods()) {
    INFO(way);
    const Inspection seen = seen_in(scene, way);
    REQUIRE(seen.worker.size() == seen.work.size());
    std::vector<int> threads(200, 0), candidates(200, 0);
    for (const Pair& pair : seen.candidates) {
      for (const int i : {pair.i, pair.j}) ++candidates[size_t(i)];
    }
    for (size_t t = 0; t < seen.worker.size(); ++t) {
      if (seen.worker[t] < 0) continue;
      const auto body = static_cast<size_t>(seen.worker[t]);
      ++threads[body];
      // The slides' threads also read what they do not test; in shared places of a hashed grid are strangers.
      if (!way.broadphase.starts_with("lecture/") && way.table != "hashed") CHECK(seen.work[t] <= candidates[body]);
    }
    CHECK(threads == std::vector<int>(200, 1));
  }
}

TEST_CASE("what is not wanted is not there") {
  const Scene scene = make_cloud({.count = 50, .smallest = 0.2, .largest = 0.2}, 25);
  const auto world = make_cpu_world(scene, settings_of({.broadphase = "sort-and-sweep"}));
  const auto held = [&](const Wanted& wanted) {
    const Inspection seen = world->inspect(wanted);
    CHECK((seen.axis >= 0) == wanted.endpoints);
    return std::vector<bool>{!seen.candidates.empty(), !seen.missed.empty(), !seen.endpoints.empty(),
                             !seen.work.empty()};
  };
  CHECK(held({}) == std::vector<bool>{false, false, false, false});
  CHECK(held({.candidates = true}) == std::vector<bool>{true, false, false, false});
  CHECK(held({.missed = true}) == std::vector<bool>{false, false, false, false});
  CHECK(held({.endpoints = true}) == std::vector<bool>{false, false, true, false});
  CHECK(held({.work = true}) == std::vector<bool>{false, false, false, true});
  const auto coarse = make_cpu_world(scene, settings_of({.broadphase = "linked-cell", .cell_size = 0.5}));
  CHECK(coarse->inspect({.missed = true}).missed.size() > 10);
  CHECK(coarse->inspect({.candidates = true}).missed.empty());
}

TEST_CASE("looking at all that may be wanted changes neither the motion nor a count of the report") {
  for (const char* const response : {"impulse", "position-based"}) {
    for (const Way& method : inspected_methods()) {
      for (const double skin : {0.0, 0.3}) {
        Way way = method;
        way.skin = skin;
        INFO(way << ", " << response);
        Settings settings = settings_of(way);
        settings.response = named<Response>(response);
        const Scene scene = falling_cloud(300);
        const auto watched = make_cpu_world(scene, settings), glanced_at = make_cpu_world(scene, settings),
                   alone = make_cpu_world(scene, settings);
        for (int k = 0; k < 20; ++k) {
          const Inspection all = watched->inspect(kAll), usual = glanced_at->inspect();
          REQUIRE(all.contacts == usual.contacts);
          REQUIRE(all.grids.size() == usual.grids.size());
          watched->step();
          glanced_at->step();
          alone->step();
        }
        (void)watched->inspect(kAll);
        (void)glanced_at->inspect();
        const Report report = watched->report();
        CHECK(report.state_hash == alone->report().state_hash);
        CHECK((counts_of(report) == counts_of(glanced_at->report())));
      }
    }
  }
}

TEST_CASE("with a skin a world shows what it shows without") {
  for (const int dimensions : {2, 3}) {
    const Scene scene = falling_cloud(300, dimensions);
    for (const Way& way : inspected_methods()) {
      INFO(way << ", dimensions " << dimensions);
      Way with = way;
      with.skin = 0.3;
      const auto bare = make_cpu_world(scene, settings_of(way)), skinned = make_cpu_world(scene, settings_of(with));
      for (int k = 0; k < 10; ++k) {
        bare->step();
        skinned->step();
      }
      const Inspection expected = bare->inspect(kAll), seen = skinned->inspect(kAll);
      CHECK(skinned->report().searches < bare->report().searches);
      CHECK(difference(seen.candidates, expected.candidates) == "");
      CHECK(seen.missed.empty());
      CHECK(seen.axis == expected.axis);
      CHECK(names_of(seen.endpoints) == names_of(expected.endpoints));
      CHECK(seen.work == expected.work);
    }
  }
}

TEST_CASE("worlds that sorted their bodies show candidates, missed pairs and endpoints by id") {
  Cloud cloud = GENERATE(Cloud{.smallest = 0.04, .largest = 0.04}, Cloud{.smallest = 0.01, .largest = 0.08},
                         Cloud{.dimensions = 2, .smallest = 0.01, .largest = 0.02, .boundary = Boundary::periodic});
  cloud.count = 4200;
  const Scene scene = make_cloud(cloud, 12);
  for (const Way& way : {Way{.broadphase = "sort-and-sweep", .threads = 2},
                         Way{.broadphase = "linked-cell", .table = "dense", .cell_size = 0.5, .threads = 2},
                         Way{.broadphase = "sorted-grid", .table = "hashed", .cell_size = 0.5}}) {
    INFO(way << ", dimensions " << cloud.dimensions);
    Settings settings = settings_of(way);
    settings.dt = 1e-5;
    const auto world = make_cpu_world(scene, settings);
    world->step();
    const std::vector<Stage> stages = world->report().stages;
    REQUIRE(std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.name == "sort bodies"; }));
    Scene now = scene;
    now.bodies = world->bodies();
    const Inspection seen = world->inspect(kAll), expected = seen_in(now, way);  // the latter sorted nothing yet
    REQUIRE(difference(seen.contacts, expected.contacts) == "");
    CHECK(difference(seen.candidates, expected.candidates) == "");
    CHECK(difference(seen.missed, expected.missed) == "");
    CHECK((way.cell_size == 0 || seen.missed.size() > 10));
    CHECK((places_of(seen.endpoints) == places_of(expected.endpoints)));
    if (way.broadphase == "sort-and-sweep") CHECK((work_of(seen) == work_of(expected)));
    if (way.broadphase == "sort-and-sweep") check_endpoints(seen);
  }
}

TEST_CASE("event-driven: candidates are the pairs in neighbouring cells, each once") {
  Settings settings;
  settings.response = Response::event_driven;
  for (const Boundary boundary : {Boundary::walls, Boundary::periodic}) {
    for (const int dimensions : {2, 3}) {
      // Across a periodic domain of two cells, spheres are neighbours by several images.
      const int across = boundary == Boundary::periodic ? 2 : 3;
      const double spacing = boundary == Boundary::periodic ? 1.75 : 1.33, length = across * spacing;
      Scene scene;
      scene.domain = {Vec3d(0.0), Vec3d(length, length, dimensions == 2 ? 0 : length), boundary, dimensions};
      Random random(8);
      for (int z = 0; z < (dimensions == 2 ? 1 : across); ++z) {
        for (int k = 0; k < across * across; ++k) {
          const Vec3d place = Vec3d(k % across, k / across, z) + Vec3d(0.5, 0.5, dimensions == 2 ? 0 : 0.5);
          add_sphere(scene, spacing * place, random.direction(dimensions), 0.6);
        }
      }
      const auto world = make_cpu_world(scene, settings);
      for (int k = 0; k < 20; ++k) world->step();
      const Inspection seen = world->inspect(kAll);
      const int count = static_cast<int>(seen.bodies.count);
      INFO("dimensions " << dimensions << ", boundary " << static_cast<int>(boundary));
      CHECK(seen.candidates.size() > 5);
      CHECK(is_list(seen.candidates, count));
      CHECK(holds_all(seen.candidates, seen.contacts));
      if (boundary == Boundary::walls) {
        CHECK(difference(seen.candidates, pairs_in_neighbouring_cells(seen.grids.at(0), count)) == "");
      }
      CHECK(seen.missed.empty());
      CHECK(seen.axis == -1);
      CHECK(seen.endpoints.empty());
      CHECK(world->inspect().candidates.empty());
    }
  }
}

TEST_CASE("worlds of no sphere and of one show nothing beside it") {
  for (const Way& way : inspected_methods()) {
    for (const int count : {0, 1}) {
      INFO(way << ", " << count);
      const Inspection seen = seen_in(make_cloud({.count = count}, 1), way);
      CHECK(seen.candidates.empty());
      CHECK(seen.missed.empty());
      CHECK(int(seen.endpoints.size()) == (way.broadphase == "sort-and-sweep" ? 2 * count : 0));
    }
  }
}
