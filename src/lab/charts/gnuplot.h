// SPDX-License-Identifier: MIT
// Draws charts with the program gnuplot (Debian: gnuplot-nox).
#pragma once

#include "lab/charts/chart.h"

namespace ballpit {

/// The path of gnuplot; empty if it is not on the PATH.
std::string gnuplot_path();

/// The chart as SVG, drawn by the gnuplot at this path. It names common fonts and embeds none. Throws RunError with
/// gnuplot's message.
std::string draw_svg(const Chart& chart, Ground ground, const std::string& gnuplot);

/// Text for SVG and HTML: with &, <, > and " as entities.
std::string html_text(std::string_view text);

}  // namespace ballpit
