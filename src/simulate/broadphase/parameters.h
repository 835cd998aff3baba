// SPDX-License-Identifier: MIT
// What every broad phase is made from. A broad phase is a class with
//
//     prepare(exec, bodies)    builds its structure for frozen positions
//     candidates()             a kernel's view of it: for_each(i, visit) calls visit(j) for the candidates j > i of
//                              body i until visit returns false; over all i each pair comes at most once
//     inspect(exec)            its structure for the audience, where it has one
//
#pragma once

#include <optional>

#include "simulate/inspection.h"
#include "simulate/state.h"

namespace ballpit {

template <class V>
struct BroadPhaseParameters {
  Box<V> box;
  int64_t count = 0;
  Scalar<V> largest_radius = 0;     ///< [m]
  std::optional<double> cell_size;  ///< in units of 2·r_max; chosen by the method where empty
};

}  // namespace ballpit
