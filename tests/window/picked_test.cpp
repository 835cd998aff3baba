// SPDX-License-Identifier: MIT
// What the panel shows of the picked sphere.
#include <string_view>

#include <catch2/catch.hpp>

#include "render/overlays/overlay.h"
#include "show/session.h"

using namespace ballpit;

namespace {

Inspection seen_in_lecture(const char* method) {
  Session session("lecture-grid", {{"threads", "1"}, {"broadphase", method}});
  return session.world().inspect({.candidates = true, .endpoints = true});
}

}  // namespace

TEST_CASE("every sphere is shown with its own cell and its position in that cell's list") {
  for (const char* method : {"linked-cell", "sorted-grid"}) {
    const Inspection seen = seen_in_lecture(method);
    for (int32_t i = 0; i < 20; ++i) {
      const auto listed = listed_in(seen, i);
      REQUIRE(listed);
      CHECK(listed->bodies.at(listed->place) == i);
      const int32_t head = seen.grids[0].head[size_t(listed->index)];
      CHECK((listed->is_sorted ? listed->bodies.back() : listed->bodies.front()) == head);
      CHECK(listed->is_sorted == (std::string_view(method) == "sorted-grid"));
      const Vec3 at = seen.bodies.position_of(i);  // cells of 1 m, five in a row
      CHECK(listed->index == int(at.y) * 5 + int(at.x));
      CHECK(listed->cell == IVec3(int(at.x), int(at.y), 0));
    }
  }
  CHECK_FALSE(listed_in(seen_in_lecture("sort-and-sweep"), 0));
  CHECK_FALSE(listed_in(seen_in_lecture("brute-force"), 0));
}

TEST_CASE("an interval reaches a radius to both sides, and its places in the sorted list are those of begin and end") {
  const Inspection seen = seen_in_lecture("sort-and-sweep");
  for (int32_t i = 0; i < 20; ++i) {
    const Walk walk = shown_walk(seen.endpoints, i);
    REQUIRE(walk.body == i);
    const float x = seen.bodies.position_of(i)[seen.axis], r = seen.bodies.radius_of(i);
    const Endpoint &begin = seen.endpoints.at(walk.first), &end = seen.endpoints.at(walk.last);
    CHECK(begin.at == Approx(x - r).margin(1e-4));
    CHECK(end.at == Approx(x + r).margin(1e-4));
    CHECK_FALSE(begin.is_end);
    CHECK(end.is_end);
    CHECK(begin.body == i);
    CHECK(end.body == i);
  }
  CHECK(shown_walk(seen_in_lecture("linked-cell").endpoints, 0).body == -1);
}

TEST_CASE("the partners of a sphere are the others of its pairs, each once and sorted") {
  const std::vector<Pair> pairs{{0, 5}, {2, 5}, {2, 7}, {5, 9}, {5, 9}};
  CHECK(partners_of(pairs, 5) == std::vector<int32_t>{0, 2, 9});
  CHECK(partners_of(pairs, 7) == std::vector<int32_t>{2});
  CHECK(partners_of(pairs, 1).empty());
  CHECK(partners_of(seen_in_lecture("brute-force").candidates, 3).size() == 19);
}
