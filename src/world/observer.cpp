// SPDX-License-Identifier: MIT
#include "world/observer.h"

#include <cmath>

namespace ballpit {

void Observer::look(World& world) {
  constexpr double kRounding = 1e-9;  // of the time
  if (!has_begun_) {
    if (world.time() < from_ * (1 - kRounding)) return;
    has_begun_ = true;
    begin_ = world.time();
    if (begin_ > 0) before_ = world.report().tally;
  }
  if (follows_ways_) follow(world.bodies().position);
}

void Observer::follow(const std::vector<Vec3d>& positions) {
  ways_.resize(positions.size(), Vec3d(0.0));
  for (size_t i = 0; i < last_.size(); ++i) {
    Vec3d way = positions[i] - last_[i];
    for (int axis = 0; axis < domain_.dimensions && domain_.boundary == Boundary::periodic; ++axis) {
      const double period = domain_.max[axis] - domain_.min[axis];
      way[axis] -= period * std::round(way[axis] / period);
    }
    ways_[i] += way;
  }
  last_ = positions;
}

Observation Observer::observation(World& world, const Report& report) const {
  Observation result{domain_, world.bodies(), report, ways_};
  result.report.time = has_begun_ ? report.time - begin_ : 0;
  Tally& tally = result.report.tally;
  tally.collisions -= before_.collisions;
  tally.virial -= before_.virial;
  tally.floor_impulse -= before_.floor_impulse;
  tally.wall_hits -= before_.wall_hits;
  return result;
}

}  // namespace ballpit
