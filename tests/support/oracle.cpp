// SPDX-License-Identifier: MIT
#include "tests/support/oracle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

#include "tests/support/scenes.h"

namespace ballpit {

namespace {

template <class Real>
std::vector<Pair> pairs_in(const Scene& scene) {
  const bool is_periodic = scene.domain.boundary == Boundary::periodic;
  const size_t n = scene.bodies.position.size();
  std::vector<glm::vec<3, Real>> position;
  for (const Vec3d& p : scene.bodies.position) position.emplace_back(p);
  const std::vector<Real> radius(scene.bodies.radius.begin(), scene.bodies.radius.end());
  Real period[3];
  for (int axis = 0; axis < 3; ++axis) period[axis] = Real(scene.domain.max[axis]) - Real(scene.domain.min[axis]);
  std::vector<Pair> pairs;
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = i + 1; j < n; ++j) {
      Real squared = 0;
      for (int axis = 0; axis < scene.domain.dimensions; ++axis) {
        Real d = position[j][axis] - position[i][axis];
        if (is_periodic) d -= period[axis] * std::round(d / period[axis]);
        squared += d * d;
      }
      const Real radii = radius[i] + radius[j];
      if (squared <= radii * radii) pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
    }
  }
  return pairs;
}

}  // namespace

std::vector<Pair> pairs_by_definition(const Scene& scene) { return pairs_in<float>(scene); }

std::vector<Pair> pairs_by_definition_in_double(const Scene& scene) { return pairs_in<double>(scene); }

std::string difference(const std::vector<Pair>& found, const std::vector<Pair>& expected) {
  if (found == expected) return "";
  std::vector<Pair> a = found, b = expected, missing, extra;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(missing));
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(extra));
  std::ostringstream text;
  text << "of " << expected.size() << " pairs, ";
  for (const auto& [what, pairs] : {std::pair{"missing", &missing}, std::pair{"too many", &extra}}) {
    text << pairs->size() << ' ' << what;
    for (size_t k = 0; k < std::min<size_t>(3, pairs->size()); ++k) {
      text << " (" << (*pairs)[k].i << ", " << (*pairs)[k].j << ')';
    }
    text << "; ";
  }
  if (missing.empty() && extra.empty()) text << "but not in canonical order";
  return text.str();
}

Scene scene_of(const Spheres& spheres, int dimensions) {
  Scene scene;
  Vec3d low(0.0), high(1.0);
  if (!spheres.position.empty()) low = high = Vec3d(spheres.position[0]);
  for (int64_t i = 0; i < spheres.count(); ++i) {
    const Vec3d p(spheres.position[static_cast<size_t>(i)]);
    low = glm::min(low, p);
    high = glm::max(high, p);
    add_sphere(scene, dimensions == 2 ? Vec3d(p.x, p.y, 0) : p, Vec3d(0.0), spheres.radius_of(i));
  }
  scene.domain = {low - 1.0, high + 1.0, Boundary::walls, dimensions};
  if (dimensions == 2) scene.domain.min.z = scene.domain.max.z = 0;
  return scene;
}

Spheres spheres_of(const Scene& scene) {
  Spheres spheres;
  for (const Vec3d& p : scene.bodies.position) spheres.position.emplace_back(p);
  spheres.radius.assign(scene.bodies.radius.begin(), scene.bodies.radius.end());
  const std::vector<float>& radius = spheres.radius;
  if (std::all_of(radius.begin(), radius.end(), [&](float r) { return r == radius[0]; }) && !radius.empty()) {
    spheres.radius.resize(1);
  }
  return spheres;
}

std::vector<Occluders> all_occluders(const BodySnapshot& bodies) {
  struct Other {
    float share;
    int64_t body;
  };
  std::vector<Occluders> result;
  for (int64_t i = 0; i < bodies.count; ++i) {
    std::vector<Other> found;
    const auto way_to = [&](int64_t j) { return bodies.position_of(j) - bodies.position_of(i); };
    for (int64_t j = 0; j < bodies.count; ++j) {
      const float own = bodies.radius_of(i), other = bodies.radius_of(j), distance = length(way_to(j));
      if (j == i || !(distance < kOcclusionReach * (own + other))) continue;
      const float part = other / std::max(distance - own, other);
      found.push_back({part * part, j});
    }
    std::sort(found.begin(), found.end(),
              [](const Other& a, const Other& b) { return a.share != b.share ? a.share > b.share : a.body < b.body; });
    Occluders& own = result.emplace_back();
    for (size_t k = 0; k < found.size(); ++k) {
      const auto [share, j] = found[k];
      if (k < kOccluders) {
        own.strongest[k] = {way_to(j), bodies.radius_of(j)};
        continue;
      }
      const float apart = length(way_to(j)) / (bodies.radius_of(i) + bodies.radius_of(j));
      const float hidden = share * std::min(1.0f, (1.5f - apart) / 0.3f);
      own.others += 0.1f * hidden;
      own.others_by_normal += 0.25f * hidden * normalize(way_to(j));
    }
  }
  return result;
}

}  // namespace ballpit
