// SPDX-License-Identifier: MIT
// Points of charts from measurements, with their error bars.
#pragma once

#include "lab/charts/chart.h"
#include "measure/statistics.h"

namespace ballpit {

/// The median with its quartiles, converted by `factor`: 1e3 gives milliseconds.
inline Point point_of(double x, const Spread& spread, double factor = 1) {
  return {x, factor * spread.median, factor * spread.lower, factor * spread.upper};
}

/// The mean with one standard error.
inline Point point_of(double x, const Mean& mean) {
  return {x, mean.value, mean.value - mean.error, mean.value + mean.error};
}

}  // namespace ballpit
