// SPDX-License-Identifier: MIT
// Searches that follow each other: what stays from one to the next must not show.
#include "world/pair_search.h"

#include <numeric>

#include <catch2/catch.hpp>

#include "measure/exact_pairs.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

std::unique_ptr<PairSearch> make_search(const Way& way) { return cpu_backend().make_pair_search(settings_of(way)); }

/// What the search finds, held against the sweep in double precision.
std::string fault(PairSearch& search, const Spheres& spheres) {
  search.find(arrays_of(spheres));
  return difference(search.pairs(), exact_pairs(arrays_of(spheres)));
}

const std::vector<std::string> kMethods{"brute-force", "sort-and-sweep", "linked-cell", "sorted-grid"};

}  // namespace

TEST_CASE("a search that has found nothing yet has no pairs and reports nothing") {
  const auto search = make_search({});
  CHECK(search->pairs().empty());
  CHECK(search->work_per_thread().empty());
  const SearchReport report = search->report();
  CHECK(report.searches == 0);
  CHECK(report.contacts == 0);
}

TEST_CASE("a report describes the last search, and counts all searches") {
  const Spheres spheres = make_family("u30", 1000, 1);
  for (const std::string& method : kMethods) {
    const auto search = make_search({.broadphase = method, .threads = 2});
    for (int k = 1; k <= 3; ++k) {
      CHECK(fault(*search, spheres) == "");
      const SearchReport report = search->report();
      CHECK(report.method == method);
      CHECK(report.reason.empty());
      CHECK(report.searches == k);
      CHECK(report.contacts == static_cast<int64_t>(search->pairs().size()));
      CHECK(report.candidates >= report.contacts);
      CHECK(report.bytes > 16 * 1000);
      CHECK_FALSE(report.stages.empty());
    }
  }
}

TEST_CASE("work is listed by thread, and adds up to the candidates") {
  for (const FamilyInfo& family : families()) {
    const Spheres spheres = make_family(family.name, 700, 1);
    for (const std::string& method : kMethods) {
      const auto search = make_search({.broadphase = method});
      search->find(arrays_of(spheres));
      const std::vector<int> work = search->work_per_thread();
      const int64_t sum = std::accumulate(work.begin(), work.end(), int64_t{0});
      INFO(family.name << ", " << method);
      CHECK(work.size() == 700);
      CHECK(sum == search->report().candidates);
    }
  }
}

TEST_CASE("spheres on a plane are searched in it, with fewer candidates than in space along z") {
  const Spheres spheres = make_family("floor", 2000, 1);
  for (const std::string& method : kMethods) {
    const auto search = make_search({.broadphase = method});
    CHECK(fault(*search, spheres) == "");
  }
  const auto across = make_search({.broadphase = "sort-and-sweep", .axis = "z"});
  CHECK(fault(*across, spheres) == "");
  CHECK(across->report().candidates == 2000 * 1999 / 2);
}

TEST_CASE("searches of different numbers of spheres follow each other") {
  for (const std::string& method : kMethods) {
    for (const double skin : {0.0, 0.1}) {
      const auto search = make_search({.broadphase = method, .skin = skin});
      for (const int count : {500, 3, 3000, 1, 500, 500}) {
        INFO(method << ", skin " << skin << ", " << count << " spheres");
        CHECK(fault(*search, make_family("u30", count, 1)) == "");
        CHECK(fault(*search, make_family("floor", count, 1)) == "");
      }
      CHECK(fault(*search, {}) == "");
      CHECK(search->pairs().empty());
    }
  }
}

TEST_CASE("many spheres in lists are searched in spatial order, and named as they came", "[slow]") {
  constexpr int kCount = 20000;
  for (const FamilyInfo& family : families()) {
    INFO(family.name);
    const auto search = make_search({.broadphase = "linked-cell", .threads = 2});
    CHECK(fault(*search, make_family(family.name, kCount, 3)) == "");
    const std::vector<Stage> stages = search->report().stages;
    CHECK(std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.name == "sort bodies"; }));
    CHECK(fault(*search, make_family(family.name, 300, 3)) == "");  // and then a few
  }
  const auto drifting = make_search({.broadphase = "linked-cell", .skin = 0.3});
  const Spheres start = make_family("poly", kCount, 3);
  for (int k = 0; k < 20; ++k) REQUIRE(fault(*drifting, drifted(start, k, 3)) == "");
  CHECK(drifting->report().searches < 10);
}

TEST_CASE("many spheres on a line, touching or far apart, are found") {
  Spheres line;
  line.radius = {0.5f};
  for (int k = 0; k < 20000; ++k) line.position.push_back({static_cast<float>((k * 7919) % 20000), 1, 2});
  Spheres place;
  for (int k = 0; k < 20000; ++k) {
    place.position.push_back(Vec3(0.0f));
    place.radius.push_back(1e-3f);
  }
  for (size_t k = 2; k < 20000; ++k) place.position[k].x = static_cast<float>(k);
  for (const std::string& method : kMethods) {
    if (method == "brute-force") continue;  // 0.2 s each
    INFO(method);
    const auto search = make_search({.broadphase = method});
    CHECK(fault(*search, line) == "");
    CHECK(search->pairs().size() == 19999);
    CHECK(fault(*search, place) == "");
    CHECK(search->pairs().size() == 1);
  }
}

TEST_CASE("with a skin, drifting spheres are found in every step, and few steps search", "[slow]") {
  for (const FamilyInfo& family : families()) {
    const Spheres start = make_family(family.name, 800, 1);
    for (const std::string& method : kMethods) {
      const auto search = make_search({.broadphase = method, .threads = 2, .skin = 0.1});
      for (int step = 0; step < 60; ++step) {
        const Spheres spheres = drifted(start, step, 7);
        INFO(family.name << ", " << method << ", step " << step);
        REQUIRE(fault(*search, spheres) == "");
      }
      CHECK(search->report().searches < 20);
    }
  }
}

TEST_CASE("with a skin, spheres that jump anywhere are found") {
  Random random(2);
  for (const std::string& method : kMethods) {
    const auto search = make_search({.broadphase = method, .skin = 0.2});
    Spheres spheres = make_family("poly", 300, 1);
    const Spheres start = spheres;
    for (int step = 0; step < 60; ++step) {
      INFO(method << ", step " << step);
      REQUIRE(fault(*search, spheres) == "");
      switch (step % 6) {
        case 0:  // far outside of the box of the start
          for (Vec3& p : spheres.position) p += Vec3(100.0f, -300.0f, 0.0f);
          break;
        case 1:
          spheres = start;
          break;
        case 2:  // swapped: nobody is where they were
          std::reverse(spheres.position.begin(), spheres.position.end());
          break;
        case 3:  // onto a plane
          for (Vec3& p : spheres.position) p.z = 1.0f;
          break;
        case 4:  // all at one point
          for (Vec3& p : spheres.position) p = start.position[0];
          break;
        default:
          spheres = start;
      }
    }
  }
}

TEST_CASE("with a skin, spheres of other sizes are searched anew") {
  const Spheres start = make_family("u30", 500, 1);
  for (const std::string& method : kMethods) {
    const auto search = make_search({.broadphase = method, .skin = 0.1});
    Spheres spheres = start;
    INFO(method);
    REQUIRE(fault(*search, spheres) == "");
    spheres.radius = {0.75f};
    CHECK(fault(*search, spheres) == "");
    spheres.radius.assign(500, 0.25f);
    CHECK(fault(*search, spheres) == "");
    spheres.radius[17] = 3.0f;
    CHECK(fault(*search, spheres) == "");
  }
}

TEST_CASE("one sphere larger than all space between the others is found at once") {
  // Its reach is thousands of the small ones' cells, almost all of them empty.
  Spheres spheres = make_family("clus", 2000, 1);
  spheres.radius.assign(2000, 0.5f);
  spheres.radius[5] = 2000.0f;
  for (const std::string& method : kMethods) {
    const auto search = make_search({.broadphase = method, .table = "auto"});
    INFO(method);
    CHECK(fault(*search, spheres) == "");
  }
}
