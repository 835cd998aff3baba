// SPDX-License-Identifier: MIT
#include "lab/measure/recall.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ballpit {

double expected_recall(const SphereSet& spheres, const std::vector<Pair>& contacts, double edge) {
  assert(!contacts.empty());
  double sum = 0;
  for (const Pair& pair : contacts) {
    const Vec3d apart =
        Vec3d(spheres.position[static_cast<size_t>(pair.j)]) - Vec3d(spheres.position[static_cast<size_t>(pair.i)]);
    double share = 1;
    for (int axis = 0; axis < 3; ++axis) share *= std::clamp(2 - std::abs(apart[axis]) / edge, 0.0, 1.0);
    sum += share;
  }
  return sum / static_cast<double>(contacts.size());
}

double recall_error(double recall, size_t contacts) {
  return std::sqrt(recall * (1 - recall) / static_cast<double>(contacts));
}

}  // namespace ballpit
