// SPDX-License-Identifier: MIT
#include "lab/chart.h"

namespace ballpit {

std::string gnuplot_script(const Chart& chart, Ground) { return "set title '" + chart.title + "'\n"; }

}  // namespace ballpit
