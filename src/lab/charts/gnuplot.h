// SPDX-License-Identifier: MIT
// Draws charts by gnuplot, a program of its own (Debian: gnuplot-nox).
#pragma once

#include <string>

#include "lab/charts/chart.h"

namespace ballpit {

/// Where gnuplot is on the PATH; empty where it is not.
std::string gnuplot_path();

/// The chart as SVG, by this gnuplot. It names fonts that systems have, and embeds none. Throws RunError with what gnuplot said.
std::string draw_svg(const Chart& chart, Ground ground, const std::string& gnuplot);

}  // namespace ballpit
