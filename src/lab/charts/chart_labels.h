// SPDX-License-Identifier: MIT
// Labels at the ends of lines: each beside its line, none over another.
#pragma once

#include <string>
#include <vector>

#include "lab/charts/chart_script.h"

namespace ballpit {

struct Label {
  double x, y;  ///< of the picture: its left end
  std::string text;
  Rgb color;
};

/// Moves labels that would cover each other apart, in their order from below, as far as the picture goes, and writes them on ground
/// of their own, so that lines behind them leave them legible.
void write_labels(ChartScript& script, std::vector<Label> labels);

}  // namespace ballpit
