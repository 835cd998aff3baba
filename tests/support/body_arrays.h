// SPDX-License-Identifier: MIT
// A scene's bodies in arrays of one vector type, as a world holds them: for tests of stages without a world.
#pragma once

#include <algorithm>
#include <vector>

#include "bodies/bodies_view.h"
#include "bodies/box.h"
#include "broad_phase/parameters.h"
#include "exec/cpu_executor.h"
#include "scene/scene.h"

namespace ballpit {

template <class V>
struct BodyArrays {
  std::vector<V> position, velocity;
  std::vector<float> radius;  ///< one where all are equal
  float inverse_mass = 1;
  Box<V> box;

  explicit BodyArrays(const Scene& scene)
      : radius(scene.bodies.radius.begin(), scene.bodies.radius.end()),
        box{narrow<V>(scene.domain.min), narrow<V>(scene.domain.max), scene.domain.boundary} {
    for (const Vec3d& p : scene.bodies.position) position.push_back(narrow<V>(p));
    for (const Vec3d& v : scene.bodies.velocity) velocity.push_back(narrow<V>(v));
    if (std::all_of(radius.begin(), radius.end(), [&](float r) { return r == radius[0]; }) && !radius.empty()) {
      radius.resize(1);
    }
  }

  int count() const { return static_cast<int>(position.size()); }

  BodiesView<V> view() const {
    return {{position.data(), count()},
            {velocity.data(), count()},
            {radius.data(), radius.size() == 1 ? 0 : 1},
            {&inverse_mass, 0}};
  }

  BroadPhaseParameters<V> parameters(const Settings& settings) const {
    return broad_phase_parameters<V>(settings, box, {radius.data(), static_cast<int64_t>(radius.size())}, count());
  }
};

}  // namespace ballpit
