// SPDX-License-Identifier: MIT
// Golden pictures of the overlays, planar and spatial, on both grounds. See golden_test.cpp.
#include <utility>

#include <catch2/catch.hpp>

#include "core/random.h"
#include "tests/support/picture_compare.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 360;
constexpr float kAspect = 16.0f / 9;

const DomainBox kBox;
const DomainBox kPlane{Vec3(0), Vec3(5, 5, 0), 2, false};

/// All data that overlays can use.
Inspection complete(const std::vector<Sphere>& spheres, const DomainBox& domain, float edge, int axis) {
  Inspection inspection = inspect(spheres, domain, edge);
  add_candidates(inspection);
  add_endpoints(inspection, axis);
  add_velocities(inspection, domain);
  return inspection;
}

Inspection stored(const std::string& name, const DomainBox& domain, float edge, int axis = 0) {
  return complete(read_spheres(BALLPIT_GOLDEN_FOLDER "/" + name + ".csv"), domain, edge, axis);
}

/// The first spheres of a stored state.
Inspection few(const std::string& name, const DomainBox& domain, float edge, size_t count, int axis = 0) {
  std::vector<Sphere> spheres = read_spheres(BALLPIT_GOLDEN_FOLDER "/" + name + ".csv");
  spheres.resize(count, Sphere{});
  return complete(spheres, domain, edge, axis);
}

std::string compare(const std::string& name, const Inspection& inspection, const DomainBox& domain,
                    const std::vector<std::string>& overlays, const char* theme, int64_t selected = -1) {
  FrameView view = view_of(inspection, domain, kAspect, overlays);
  view.selected = selected;
  return compare_with_golden(name, draw(view, kWidth, kHeight, {theme_named(theme), 1}));
}

}  // namespace

TEST_CASE("golden: pairs of a planar scene, one of them missed, on white") {
  // Cells of 0.4 m, with radii up to 0.34 m: too small.
  CHECK(compare("pairs_plane", stored("plane_touching", kPlane, 0.4f), kPlane, {"pairs"}, "projector") == "");
}

TEST_CASE("golden: pairs of a cloud, on dark") {
  CHECK(compare("pairs_cloud_dark", stored("cloud", kBox, 0.125f), kBox, {"pairs"}, "dark") == "");
}

TEST_CASE("golden: few pairs of a cloud, and those missed by too small cells, on both grounds") {
  CHECK(compare("pairs_cloud", stored("cloud", kBox, 0.07f), kBox, {"pairs"}, "projector") == "");
  CHECK(compare("pairs_cloud_missed", stored("cloud", kBox, 0.03f), kBox, {"pairs"}, "projector") == "");
  CHECK(compare("pairs_cloud_missed_dark", stored("cloud", kBox, 0.03f), kBox, {"pairs"}, "dark") == "");
}

TEST_CASE("golden: intervals of three spheres as on slide 4") {
  const Inspection three =
      complete({{{1.0f, 2.6f, 0}, 0.6f}, {{2.6f, 3.4f, 0}, 0.8f}, {{3.3f, 1.6f, 0}, 0.9f}}, kPlane, 0, 0);
  CHECK(compare("intervals_three", three, kPlane, {"intervals", "labels"}, "projector") == "");
}

TEST_CASE("golden: intervals along y, on dark") {
  CHECK(compare("intervals_upright_dark", few("plane", kPlane, 0, 10, 1), kPlane, {"intervals", "labels"}, "dark", 3) ==
        "");
}

TEST_CASE("golden: intervals of twenty spheres, one of them selected") {
  CHECK(compare("intervals_plane", stored("plane", kPlane, 0), kPlane, {"intervals"}, "projector", 12) == "");
}

TEST_CASE("golden: intervals of a few spheres in a box") {
  for (const int axis : {0, 1, 2}) {
    const std::string name = std::string("intervals_box_") + "xyz"[axis];
    CHECK(compare(name, few("cloud", kBox, 0, 8, axis), kBox, {"intervals", "labels"}, "projector") == "");
  }
}

TEST_CASE("golden: intervals of a cloud, brackets only, on dark") {
  CHECK(compare("intervals_cloud_dark", stored("cloud", kBox, 0), kBox, {"intervals"}, "dark") == "");
}

TEST_CASE("golden: head and next of a planar grid, on both grounds") {
  const Inspection plane = stored("plane", kPlane, 1);
  CHECK(compare("lists_plane", plane, kPlane, {"grid", "labels", "lists"}, "projector") == "");
  CHECK(compare("lists_plane_dark", plane, kPlane, {"grid", "labels", "lists"}, "dark", 9) == "");
}

TEST_CASE("golden: offsets and sorted bodies of a planar grid, and a hashed table, on both grounds") {
  Inspection plane = stored("plane", kPlane, 1);
  GridInspection& grid = plane.grids[0];
  CellArrays sorted{true, false, {0}, {}};
  for (const int32_t head : grid.head) {
    for (int32_t body = head; body >= 0; body = grid.next[static_cast<size_t>(body)]) sorted.bodies.push_back(body);
    sorted.cells.push_back(static_cast<int32_t>(sorted.bodies.size()));
  }
  grid.arrays = sorted;
  CHECK(compare("ranges_plane", plane, kPlane, {"grid", "labels", "lists"}, "projector") == "");
  CHECK(compare("ranges_plane_dark", plane, kPlane, {"grid", "labels", "lists"}, "dark", 9) == "");
  CellArrays hashed{false, true, std::vector<int32_t>(16, -1), {}};
  for (int32_t body = 0; body < 8; ++body) {
    int32_t& head = hashed.cells[static_cast<size_t>(body * 7 % 5)];
    hashed.bodies.push_back(std::exchange(head, body));
  }
  Inspection eight = few("plane", kPlane, 1, 8);
  eight.grids[0].arrays = hashed;
  CHECK(compare("places_plane", eight, kPlane, {"lists"}, "projector") == "");
}

TEST_CASE("golden: the lanes of two warps, one of them half empty, on both grounds") {
  Inspection plane = stored("plane", kPlane, 1);
  for (int t = 0; t < 48; ++t) plane.work.push_back(t % 5 == 0 ? 0 : 1 + t % 7);
  CHECK(compare("warps_plane", plane, kPlane, {"warps"}, "projector") == "");
  plane.work[7] = 60;
  CHECK(compare("warps_plane_dark", plane, kPlane, {"warps"}, "dark") == "");
}

TEST_CASE("golden: the lengths of the lists of a cloud") {
  CHECK(compare("lists_cloud", stored("cloud", kBox, 0.125f), kBox, {"lists"}, "projector") == "");
}

TEST_CASE("golden: numbers of cells and spheres, on both grounds") {
  CHECK(compare("labels_plane", stored("plane", kPlane, 1), kPlane, {"grid", "labels"}, "projector") == "");
  CHECK(compare("labels_cloud_dark", stored("cloud", kBox, 0), kBox, {"labels"}, "dark") == "");
}

TEST_CASE("golden: the densest of thousands of cells, on both grounds") {
  Random random(5);
  std::vector<Sphere> spheres;
  const auto at = [&] { return static_cast<float>(random.uniform(0.02, 0.98)); };
  for (int k = 0; k < 7000; ++k) spheres.push_back({{at(), at(), at()}, 0.01f});
  const Inspection inspection = inspect(spheres, kBox, 0.05f);
  const FrameView view = view_of(inspection, kBox, kAspect, {"grid"});
  for (const auto& [name, theme] : {std::pair{"grid_densest", "projector"}, {"grid_densest_dark", "dark"}})
    CHECK(compare_with_golden(name, draw(view, kWidth, kHeight, {theme_named(theme), 1})) == "");
}

TEST_CASE("golden: a selected sphere and its block") {
  CHECK(compare("selection_plane", stored("plane", kPlane, 1), kPlane, {"grid"}, "projector", 12) == "");
  CHECK(compare("selection_box", stored("cloud", kBox, 0.125f), kBox, {"grid"}, "projector", 0) == "");
  CHECK(compare("selection_box_dark", stored("cloud", kBox, 0.125f), kBox, {"grid"}, "dark", 0) == "");
}

TEST_CASE("golden: velocities, on both grounds") {
  CHECK(compare("velocity_plane", stored("plane", kPlane, 0.7f), kPlane, {"velocity", "pairs"}, "projector") == "");
  CHECK(compare("velocity_cloud_dark", stored("cloud", kBox, 0), kBox, {"velocity"}, "dark") == "");
}

TEST_CASE("golden: swept ways past other spheres, planar and spatial") {
  const auto compare_swept = [](const std::string& name, const std::vector<Sphere>& spheres, const DomainBox& domain,
                                const std::vector<float>& velocity, const char* theme) {
    Inspection inspection = inspect(spheres, domain);
    inspection.bodies.velocity = velocity;
    FrameView view = view_of(inspection, domain, kAspect, {"swept"});
    view.step = 0.5f;
    return compare_with_golden(name, draw(view, kWidth, kHeight, {theme_named(theme), 1}));
  };
  CHECK(compare_swept("swept_plane", {{{0.7f, 2.6f, 0}, 0.3f}, {{2.5f, 2.5f, 0}, 0.5f}, {{4, 1, 0}, 0.4f}}, kPlane,
                      {7, 0, 0, 0, -1, 2}, "projector") == "");
  CHECK(compare_swept("swept_box_dark",
                      {{{0.2f, 0.5f, 0.5f}, 0.06f}, {{0.5f, 0.5f, 0.5f}, 0.12f}, {{0.7f, 0.8f, 0.3f}, 0.1f}}, kBox,
                      {1.2f, 0, 0, 0, 0, 0, 0.2f, -0.9f, 0.4f}, "dark") == "");
}

TEST_CASE("golden: spheres beside their ghosts, the curve, and the first wrong collision, on both grounds") {
  GhostInspection ghost;
  for (int k = 0; k <= 60; ++k) {
    const double median = k < 2 ? 0 : std::min(1e-8 * std::exp(0.4 * k), 1.5);
    ghost.curve.push_back({0.05 * k, median, std::min(30 * median, 6.0)});
  }
  ghost.wrong = WrongCollision{Timing::late, 0.913, 0.0021, 3, 5, {2.9f, 2.1f, 0}};
  ghost.growth = 8;
  ghost.growth_from = 0.8;
  Inspection plane = stored("plane", kPlane, 0);
  for (int k = 0; k < 20; ++k) ghost.ahead.emplace_back(0.03f * static_cast<float>(k), k % 3 == 0 ? 0.0f : -0.2f, 0);
  plane.ghost = ghost;
  CHECK(compare("ghost_plane", plane, kPlane, {"ghost"}, "projector") == "");

  Inspection cloud = few("cloud", kBox, 0, 30);
  ghost.wrong = WrongCollision{Timing::missed, 0.4, 0, 3, -1, {0.5f, 0, 0.5f}};
  ghost.ahead.clear();
  for (int k = 0; k < 30; ++k) ghost.ahead.emplace_back(0.01f * static_cast<float>(k % 7), 0.05f, -0.03f);
  cloud.ghost = ghost;
  CHECK(compare("ghost_cloud_dark", cloud, kBox, {"ghost"}, "dark") == "");
}

TEST_CASE("the comparison of pictures detects a missing or moved label, and a shifted line") {
  const Inspection plane = stored("plane", kPlane, 1);
  const FrameView view = view_of(plane, kPlane, kAspect, {"grid", "labels"});
  const Image whole = draw(view, kWidth, kHeight);

  Inspection renumbered = plane;  // the same discs, two of their numbers exchanged
  std::swap(renumbered.bodies.position[0], renumbered.bodies.position[2]);
  std::swap(renumbered.bodies.position[1], renumbered.bodies.position[3]);
  std::swap(renumbered.bodies.radius[0], renumbered.bodies.radius[1]);
  CHECK(worst_block(draw(view_of(renumbered, kPlane, kAspect, {"grid", "labels"}), kWidth, kHeight), whole) > 8);

  Inspection few_cells = plane;
  few_cells.grids[0].head.pop_back();  // the last cell's number
  const Image without = draw(view_of(few_cells, kPlane, kAspect, {"labels"}), kWidth, kHeight);
  CHECK(worst_block(without, draw(view_of(plane, kPlane, kAspect, {"labels"}), kWidth, kHeight)) > 8);

  Inspection moved = plane;  // one end of an interval
  moved.endpoints[5].at += 0.08f;
  const Image staff = draw(view_of(plane, kPlane, kAspect, {"intervals"}), kWidth, kHeight);
  CHECK(worst_block(draw(view_of(moved, kPlane, kAspect, {"intervals"}), kWidth, kHeight), staff) > 8);
}
