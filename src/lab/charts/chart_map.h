// SPDX-License-Identifier: MIT
// Maps: cells of measured values under the lines of a chart, and what their colours mean beside it.
#pragma once

#include <vector>

#include "lab/charts/chart_script.h"

namespace ballpit {

/// Borders of cells: half way between centres, by ratio where the axis is logarithmic.
std::vector<double> edges_of(const std::vector<double>& centers, Scale scale);

void draw_map(ChartScript& script, const Map& map);

}  // namespace ballpit
