// SPDX-License-Identifier: MIT
// Double precision: the same program, where float has run out of digits.
#include <algorithm>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/hits.h"
#include "tests/support/inputs.h"
#include "tests/support/oracle.h"
#include "tests/support/scenes.h"

using namespace ballpit;

namespace {

std::vector<Pair> contacts_in(const std::string& precision, const Scene& scene, const Way& way) {
  Settings settings = settings_of(way);
  settings.precision = named<Precision>(precision);
  return make_cpu_world(scene, settings)->inspect().contacts;
}

/// Pairs of spheres that are apart from touching by `hair` of their distance: every other pair overlaps by it, the others
/// miss. Spheres 2k and 2k + 1 are a pair; some lie across a border of a periodic domain. Pairs may come to lie in others.
struct Hairs {
  Scene scene;
  std::vector<Pair> touching;  ///< of the pairs made so
  std::vector<Pair> missing;   ///< the others
};

Hairs make_hairs(const Domain& domain, double hair, bool is_mixed, uint64_t seed) {
  Random random(seed);
  Hairs hairs;
  hairs.scene.domain = domain;
  const Vec3d size = domain.max - domain.min;
  for (int k = 0; k < 200; ++k) {
    const double ri = is_mixed ? random.uniform(0.01, 0.1) : 0.05, rj = is_mixed ? random.uniform(0.01, 0.1) : 0.05;
    Vec3d p = random.uniform(domain.min, domain.max);
    const int axis = k % domain.dimensions;
    if (k % 4 == 0) p[axis] = domain.min[axis] + random.uniform(-0.03, 0.03);  // about a border
    if (k % 16 == 0) p[axis] = domain.min[axis];
    Vec3d n = random.direction(domain.dimensions);
    if (k % 8 < 2) n = Vec3d(axis == 0, axis == 1, axis == 2);  // along the axis: touching intervals, too
    const bool touches = k % 2 == 0;
    Vec3d q = p + (ri + rj) * (touches ? 1 - hair : 1 + hair) * n;
    for (Vec3d* r : {&p, &q}) {
      if (domain.boundary == Boundary::periodic) *r -= size * glm::floor((*r - domain.min) / size);
      if (domain.dimensions == 2) r->z = 0;
    }
    add_sphere(hairs.scene, p, Vec3d(0.0), ri);
    add_sphere(hairs.scene, q, Vec3d(0.0), rj);
    (touches ? hairs.touching : hairs.missing).push_back({2 * k, 2 * k + 1});
  }
  return hairs;
}

bool lists(const std::vector<Pair>& pairs, const Pair& pair) {
  return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
}

int64_t wrong_among(const Hairs& hairs, const std::vector<Pair>& found) {
  const auto is_found = [&](const Pair& pair) { return lists(found, pair); };
  return std::count_if(hairs.missing.begin(), hairs.missing.end(), is_found) +
         static_cast<int64_t>(hairs.touching.size()) -
         std::count_if(hairs.touching.begin(), hairs.touching.end(), is_found);
}

/// A sphere at x = 65536 m in a box around it, moving at 0.2 m/s.
Scene far_out() {
  Scene scene;
  scene.domain = {{65530, 0, 0}, {65540, 1, 1}, Boundary::walls, 3};
  add_sphere(scene, {65536, 0.5, 0.5}, {0.2, 0, 0});
  return scene;
}

}  // namespace

TEST_CASE("in double precision worlds find every contact once, in order, whatever the method and the spheres") {
  for (const Input& input : inputs()) {
    const Scene scene = input.make(1);
    const std::vector<Pair> expected = pairs_by_definition_in_double(scene);
    for (const Way& way : ways(scene.domain.dimensions)) {
      INFO(input.name << ", " << way << ", " << expected.size() << " contacts");
      REQUIRE(difference(contacts_in("double", scene, way), expected) == "");
    }
  }
}

TEST_CASE("float and double find the same contacts where no pair is nearer to touching than float can tell") {
  for (const Cloud& cloud : {Cloud{.count = 500, .smallest = 0.08, .largest = 0.08},
                             Cloud{.count = 500, .smallest = 0.01, .largest = 0.1, .boundary = Boundary::periodic},
                             Cloud{.count = 500, .dimensions = 2, .smallest = 0.05, .largest = 0.05}}) {
    const Scene scene = make_cloud(cloud, 2);
    const std::vector<Pair> expected = contacts_in("float", scene, {.broadphase = "brute-force"});
    CHECK(expected.size() > 100);
    CHECK(difference(contacts_in("double", scene, {.broadphase = "brute-force"}), expected) == "");
  }
}

TEST_CASE(
    "in double precision spheres that touch by 1e-12 are found and those that miss by it are not, by every method") {
  // What float cannot tell: at a distance of 0.1 m and coordinates of 1 m its last digit is 1e-7 m.
  for (const Boundary boundary : {Boundary::walls, Boundary::open_top, Boundary::periodic}) {
    for (const int dimensions : {3, 2}) {
      for (const bool is_mixed : {false, true}) {
        for (const double low : {-1.0, 100.0, -1e5}) {
          const double flat = dimensions == 2 ? 0.0 : 1.0;
          const Domain domain{low * Vec3d(1, 1, flat), (low + 2) * Vec3d(1, 1, flat), boundary, dimensions};
          const double hair = low == -1 ? 1e-12 : 1e-8;  // far out double is coarser, too: 1.5e-11 m at 1e5 m
          const Hairs hairs = make_hairs(domain, hair, is_mixed, 3);
          const std::vector<Pair> expected = pairs_by_definition_in_double(hairs.scene);
          REQUIRE(wrong_among(hairs, expected) == 0);
          CHECK(wrong_among(hairs, pairs_by_definition(hairs.scene)) > 20);
          for (Way way : ways(dimensions)) {
            for (const double skin : {0.0, 0.1}) {
              way.skin = skin;
              INFO(way << ", dimensions " << dimensions << ", low " << low << ", boundary " << int(boundary));
              REQUIRE(difference(contacts_in("double", hairs.scene, way), expected) == "");
            }
          }
        }
      }
    }
  }
}

TEST_CASE("in double precision a sweep loses no contact to its keys of single precision, at any place along the axis") {
  // Keys are rounded to float: 6e-8 m about 1 m, 4 mm about 1e5 m. Pairs whose intervals touch by less, at many places, at
  // the border of a periodic domain as well; one world each, so that nobody else's interval helps.
  for (const double low : {-1.0, -65536.0, 1e5}) {
    for (const Boundary boundary : {Boundary::walls, Boundary::periodic}) {
      Random random(9);
      const double hair = low == -1 ? 1e-12 : 1e-8;
      int64_t lost = 0;
      for (int k = 0; k < 1500; ++k) {
        Scene scene;
        scene.domain = {{low, 0, 0}, {low + 2, 2, 2}, boundary, 3};
        const double ri = random.uniform(0.01, 0.2), rj = random.uniform(0.01, 0.2), length = (ri + rj) * (1 - hair);
        double x = random.uniform(low, low + 2), y = x + length;
        if (k % 2 == 0) {
          y = low + random.uniform(0.0, 1.0) * length;
          x = y - length;
        }
        if (boundary == Boundary::periodic) {
          if (x < low) x += 2;
          if (y >= low + 2) y -= 2;
        } else if (x < low || y > low + 2) {
          continue;
        }
        add_sphere(scene, {x, 1, 1}, Vec3d(0.0), ri);
        add_sphere(scene, {y, 1, 1}, Vec3d(0.0), rj);
        REQUIRE(pairs_by_definition_in_double(scene).size() == 1);
        lost += contacts_in("double", scene, {.broadphase = "sort-and-sweep", .axis = "x"}).size() != 1;
      }
      INFO("low " << low << ", boundary " << int(boundary));
      CHECK(lost == 0);
    }
  }
}

TEST_CASE(
    "in double precision a sphere that crosses periodic borders a hundred times is where it should be, to rounding") {
  for (const auto& [response, integrator] :
       std::vector<std::pair<std::string, std::string>>{{"kinematic", "auto"},
                                                        {"impulse", "auto"},
                                                        {"position-based", "auto"},
                                                        {"penalty", "velocity-verlet"},
                                                        {"penalty", "symplectic-euler"},
                                                        {"penalty", "explicit-euler"},
                                                        {"penalty", "rk4"}}) {
    Scene scene;
    scene.domain = {Vec3d(1.0), Vec3d(1.3, 1.7, 2.0), Boundary::periodic, 3};
    add_sphere(scene, Vec3d(1.1), {30, -70, 10}, 0.01);
    const auto world = make_cpu_world(scene, settings_of(response, 1.0 / 1024, integrator));
    for (int k = 0; k < 1024; ++k) world->step();
    const Vec3d period = scene.domain.max - scene.domain.min, end = Vec3d(1.1) + Vec3d(30, -70, 10);
    const Vec3d off = world->bodies().position[0] - end;
    INFO(response << ", " << integrator);
    CHECK(length(off - period * glm::round(off / period)) < 1e-11);
  }
}

TEST_CASE("far from the origin a slow sphere stands still in float and moves in double, by every response") {
  // v·dt = 3.3 mm, and float's numbers about 65536 m are 7.8 mm apart: what is below half of that is rounded away.
  for (const char* const response : {"kinematic", "impulse", "penalty", "position-based"}) {
    for (const char* const precision : {"float", "double"}) {
      Settings settings = settings_of(response, 1.0 / 60);
      settings.precision = named<Precision>(precision);
      const auto world = make_cpu_world(far_out(), settings);
      for (int k = 0; k < 60; ++k) world->step();
      INFO(response << ", " << precision);
      const double moved = world->bodies().position[0].x - 65536;
      CHECK(moved == Approx(precision == std::string("float") ? 0.0 : 0.2).margin(1e-9));
    }
  }
}

TEST_CASE("far from the origin float moves what goes more than half the distance of its numbers in a step") {
  Scene scene = far_out();
  scene.bodies.velocity[0].x = 0.24;  // 4.0 mm a step, more than 3.9
  Settings settings = settings_of("impulse", 1.0 / 60);
  settings.precision = Precision::float32;
  const auto world = make_cpu_world(scene, settings);
  for (int k = 0; k < 60; ++k) world->step();
  CHECK(world->bodies().position[0].x - 65536 == Approx(60 / 128.0));  // twice as fast as it should
}
