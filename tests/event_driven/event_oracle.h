// SPDX-License-Identifier: MIT
// Event-driven motion by brute force, an oracle for the fast version. All spheres are at the same time; before each
// event it computes the time of collision for every pair, image and wall. O(n²) an event, in extended precision, with
// textbook formulas: it shares no line of code with the version that it tests.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "tests/support/scenes.h"

namespace ballpit {

class EventOracle {
  using Real = long double;
  using Vec = std::array<Real, 3>;

 public:
  explicit EventOracle(const Scene& scene) : scene_(scene) {
    for (const Vec3d& p : scene.bodies.position) x_.push_back({p.x, p.y, p.z});
    for (const Vec3d& v : scene.bodies.velocity) v_.push_back({v.x, v.y, v.z});
  }

  int collisions() const { return collisions_; }
  double time() const { return double(time_); }
  Vec3d velocity(int i) const { return {double(v_[i][0]), double(v_[i][1]), double(v_[i][2])}; }

  /// The distance of sphere i, or its nearest image, from p [m].
  double distance_to(int i, const Vec3d& p) const {
    Real squared = 0;
    for (int a = 0; a < dimensions(); ++a) {
      Real d = x_[i][a] - p[a];
      if (is_periodic()) d -= period(a) * std::round(d / period(a));
      squared += d * d;
    }
    return double(std::sqrt(squared));
  }

  void advance(double time) { fly(time - time_); }

  void next_event() {
    Event first;
    const int n = int(x_.size());
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j) find_pair(i, j, first);
      if (!is_periodic()) find_walls(i, first);
    }
    fly(first.wait);
    first.j >= 0 ? collide(first) : bounce(first);
  }

 private:
  struct Event {
    Real wait = 1e30L;
    int i = -1, j = -1;  // j = −1: a wall
    int axis = 0, side = 0;
    Vec image{0, 0, 0};  // [m] added to sphere j
  };

  int dimensions() const { return scene_.domain.dimensions; }
  bool is_periodic() const { return scene_.domain.boundary == Boundary::periodic; }
  Real period(int a) const { return Real(scene_.domain.max[a]) - scene_.domain.min[a]; }
  Real radius(int i) const { return scene_.bodies.radius[i]; }
  Real mass(int i) const { return scene_.bodies.mass[i]; }

  void fly(Real t) {
    for (size_t i = 0; i < x_.size(); ++i) {
      for (int a = 0; a < dimensions(); ++a) {
        const Real g = scene_.physics.gravity[a];
        x_[i][a] += v_[i][a] * t + g * t * t / 2;
        v_[i][a] += g * t;
      }
    }
    time_ += t;
  }

  // Spheres fly straight through the images of a periodic domain, so more images than the neighbours count.
  void find_pair(int i, int j, Event& first) const {
    const int reach = is_periodic() ? 3 : 0, depth = dimensions() == 3 ? reach : 0;
    Vec home{0, 0, 0};
    for (int a = 0; a < dimensions() && is_periodic(); ++a) {
      home[a] = -period(a) * std::round((x_[j][a] - x_[i][a]) / period(a));
    }
    for (int p = -reach; p <= reach; ++p) {
      for (int q = -reach; q <= reach; ++q) {
        for (int r = -depth; r <= depth; ++r) {
          find_image(i, j, {home[0] + p * period(0), home[1] + q * period(1), home[2] + r * period(2)}, first);
        }
      }
    }
  }

  void find_image(int i, int j, const Vec& image, Event& first) const {
    Real dd = 0, du = 0, uu = 0;
    for (int a = 0; a < dimensions(); ++a) {
      const Real d = x_[j][a] + image[a] - x_[i][a], u = v_[j][a] - v_[i][a];
      dd += d * d, du += d * u, uu += u * u;
    }
    const Real radii = radius(i) + radius(j), discriminant = du * du - uu * (dd - radii * radii);
    if (du >= 0 || discriminant <= 0) return;
    const Real wait = (-du - std::sqrt(discriminant)) / uu;
    if (wait < first.wait) first = {wait, i, j, 0, 0, image};
  }

  void find_walls(int i, Event& first) const {
    for (int a = 0; a < dimensions(); ++a) {
      for (const int side : {-1, 1}) {
        if (a == 1 && side > 0 && scene_.domain.boundary == Boundary::open_top) continue;
        const Real wall = side < 0 ? scene_.domain.min[a] + radius(i) : scene_.domain.max[a] - radius(i);
        const Real wait = fall_time(side * (wall - x_[i][a]), side * v_[i][a], side * Real(scene_.physics.gravity[a]));
        if (wait < first.wait) first = {wait, i, -1, a, side, {}};
      }
    }
  }

  /// The first time at which h = v·t + g·t²/2 while moving towards the wall.
  static Real fall_time(Real h, Real v, Real g) {
    if (g == 0) return v > 0 ? h / v : 1e30L;
    const Real discriminant = v * v + 2 * g * h;
    if (discriminant < 0) return 1e30L;
    const Real t = (-v + std::sqrt(discriminant)) / g;  // the root at which the speed towards the wall is +√
    return t >= 0 ? t : 1e30L;
  }

  void collide(const Event& event) {
    const int i = event.i, j = event.j;
    const Real radii = radius(i) + radius(j), reduced = mass(i) * mass(j) / (mass(i) + mass(j));
    Vec n{0, 0, 0};
    Real approach = 0;
    for (int a = 0; a < dimensions(); ++a) {
      n[a] = (x_[j][a] + event.image[a] - x_[i][a]) / radii;
      approach += (v_[i][a] - v_[j][a]) * n[a];
    }
    const Real impulse = (1 + Real(scene_.physics.restitution)) * reduced * approach;
    for (int a = 0; a < dimensions(); ++a) {
      v_[i][a] -= impulse / mass(i) * n[a];
      v_[j][a] += impulse / mass(j) * n[a];
    }
    ++collisions_;
  }

  void bounce(const Event& event) { v_[event.i][event.axis] *= -Real(scene_.physics.wall_restitution); }

  Scene scene_;
  std::vector<Vec> x_, v_;
  Real time_ = 0;
  int collisions_ = 0;
};

/// 20 spheres of unequal radii and masses on a lattice; gravity unless the domain is periodic.
inline Scene make_oracle_scene(int dimensions, Boundary boundary, uint64_t seed) {
  Random random(seed);
  Scene scene;
  const bool is_planar = dimensions == 2;
  scene.domain = {{-1, 0, is_planar ? 0.0 : 2.0}, {4, 4, is_planar ? 0.0 : 4.0}, boundary, dimensions};
  scene.physics.restitution = 0.95;
  scene.physics.wall_restitution = 0.9;
  if (boundary != Boundary::periodic) scene.physics.gravity = {0.2, -3, is_planar ? 0.0 : 0.1};
  for (int k = 0; k < 20; ++k) {
    const Vec3d p = is_planar ? Vec3d(-0.5 + k % 5, 0.5 + 0.95 * (k / 5), 0)
                              : Vec3d(-0.5 + k % 5, 0.7 + 1.3 * (k / 10), 2.5 + k / 5 % 2);
    Vec3d v = random.uniform(Vec3d(-3.0), Vec3d(3.0));
    if (is_planar) v.z = 0;
    add_sphere(scene, p, v, random.uniform(0.15, 0.45), random.uniform(0.5, 3.0));
  }
  return scene;
}

}  // namespace ballpit
