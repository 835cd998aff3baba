// SPDX-License-Identifier: MIT
// A heap comes to rest, and stays so: an RMS speed below 0.03 m/s after 5 s, by every response that carries one, at settings
// that a scene would use. Kinematic spheres carry nothing, and event-driven ones never rest.
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "tests/support/hits.h"

using namespace ballpit;

namespace {

/// 80 spheres of radii 4 to 6 cm let fall into a box of 0.4 m × 0.4 m, four layers or five, `offset` away from the origin.
Scene heap(double offset = 0) {
  Scene scene;
  scene.domain = {Vec3d(offset), Vec3d(offset) + Vec3d(0.4, 1, 0.4), Boundary::open_top, 3};
  scene.physics.gravity = {0, -9.81, 0};
  scene.physics.restitution = scene.physics.wall_restitution = 0.4;
  scene.physics.stiffness = 1e5;
  Random random(2);
  for (int k = 0; k < 80; ++k) {
    const double radius = random.uniform(0.04, 0.06);
    const Vec3d place = 0.125 * (Vec3d(k % 3, k / 9, k / 3 % 3) + 0.5) + Vec3d(0.0125, 0, 0.0125);
    add_sphere(scene, Vec3d(offset) + place, 0.2 * random.direction(3), radius,
               1000 * 4 * M_PI / 3 * radius * radius * radius);
  }
  return scene;
}

struct Rest {
  double rms_speed, overlap;  ///< [m/s], of a radius
};

Rest rest_of(const Scene& scene, Settings settings, const std::string& precision) {
  settings.precision = named<Precision>(precision);
  const auto world = make_cpu_world(scene, settings);
  step_until(*world, 5);
  double squared = 0;
  for (const Vec3d& v : world->bodies().velocity) squared += dot(v, v);
  return {std::sqrt(squared / double(scene.bodies.size())), world->report().max_overlap};
}

Settings settings_for(const std::string& response) {
  Settings settings = settings_of(response, response == "penalty" ? 1.0 / 4000 : 1.0 / 240);
  if (response == "position-based") settings.substeps = 8;
  settings.broadphase = BroadPhase::sorted_grid;
  return settings;
}

}  // namespace

TEST_CASE("a heap is at rest after 5 s, by impulses, springs with dashpots and positions, in float and double",
          "[slow]") {
  for (const char* const response : {"impulse", "penalty", "position-based"}) {
    for (const char* const precision : {"float", "double"}) {
      const Rest rest = rest_of(heap(), settings_for(response), precision);
      INFO(response << ", " << precision << ": RMS " << rest.rms_speed << " m/s, overlap " << rest.overlap);
      CHECK(rest.rms_speed < 0.03);
      CHECK(rest.overlap < 0.2);  // impulse.h: c/push·n·g·dt², 0.16 of a radius for six contacts and five layers
    }
  }
}

TEST_CASE("far from the origin a heap in float jitters by about half a last digit a substep, and in double not at all",
          "[slow]") {
  // Positions are rounded to the distance of float's numbers, ulp(x), in each substep h; measured: 0.42 to 0.47 ulp(x)/h.
  struct Row {
    const char* response;
    double offset, h;
  };
  for (const Row& row :
       {Row{"impulse", 4096, 1.0 / 240}, Row{"penalty", 1024, 1.0 / 4000}, Row{"position-based", 1024, 1.0 / 1920}}) {
    const Rest in_float = rest_of(heap(row.offset), settings_for(row.response), "float"),
               in_double = rest_of(heap(row.offset), settings_for(row.response), "double");
    const double ulp = row.offset * std::numeric_limits<float>::epsilon();
    INFO(row.response << ": RMS " << in_float.rms_speed << " and " << in_double.rms_speed << " m/s; ulp/h "
                      << ulp / row.h);
    CHECK(in_float.rms_speed > 0.03);
    CHECK(in_float.rms_speed == Approx(0.45 * ulp / row.h).epsilon(0.4));
    CHECK(in_double.rms_speed < 0.03);
  }
}
