// SPDX-License-Identifier: MIT
// Maps: coloured cells under the lines of a chart, and beside them what the colours mean.
#pragma once

#include <vector>

#include "lab/charts/chart_script.h"

namespace ballpit {

/// Borders of cells, half way between their centres; on a logarithmic axis, by ratio.
std::vector<double> edges_of(const std::vector<double>& centers, Scale scale);

void draw_map(ChartScript& script, const Map& map);

}  // namespace ballpit
