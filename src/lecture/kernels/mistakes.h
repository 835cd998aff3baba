// SPDX-License-Identifier: MIT
// Mistakes that students make with linked cells. Lectures switch them on and show the pairs that are missed or doubled.
#pragma once

#include <cmath>

#include "core/host_device.h"
#include "core/math.h"

namespace ballpit::lecture {

/// int(p / edge) − int(low / edge): −0.5 and 0.5 are in one cell.
template <class Real, class Grid>
HOST_DEVICE Real to_int(Real p, const Grid& grid, int axis) {
  const Real per = grid.inverse_edge[axis];
  return std::trunc(p * per) - std::trunc(grid.origin[axis] * per);
}

struct Mistakes {
  bool truncates = false;     ///< int() for floor
  bool forgets_wrap = false;  ///< no cells beyond a periodic border
  bool tests_twice = false;   ///< both halves of a pair: (i, j), (j, i)

  /// Whether a cell around `own` is forgotten: one on the other side of a periodic domain.
  HOST_DEVICE bool leave_out(const IVec3& own,
                             const IVec3& cell) const {
    const IVec3 d = own - cell;
    return forgets_wrap &&
           (d.x * d.x > 1 || d.y * d.y > 1 || d.z * d.z > 1);
  }
};

}  // namespace ballpit::lecture
