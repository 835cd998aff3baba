// SPDX-License-Identifier: MIT
#include "lab/charts/gnuplot.h"

#include "core/error.h"
#include "core/program.h"
#include "lab/charts/html.h"

namespace ballpit {

namespace {

void replace_all(std::string& text, const std::string& what, const std::string& with) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
}

}  // namespace

std::string gnuplot_path() { return find_program("gnuplot"); }

std::string draw_svg(const Chart& chart, Ground ground, const std::string& gnuplot) {
  ProgramCall call{gnuplot, {"--default-settings"}};  // ignores the user's settings
  call.input = gnuplot_script(chart, ground);
  call.gets_interrupts = false;  // Ctrl-C ends the laboratory after the current chart
  ProgramResult result = run_program(call);
  std::string& svg = result.output;
  if (result.status != 0 || svg.find("</svg>") == std::string::npos) {
    throw RunError(gnuplot, "failed on chart " + chart.name + ": " + result.errors);
  }
  // gnuplot accepts one font family only. Without crisp edges, the background shows between the cells of a map.
  replace_all(svg, "font-family=\"sans-serif\"",
              "font-family=\"Roboto, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif\"");
  replace_all(svg, "<title>Gnuplot</title>", "<title>" + html_text(chart.title) + "</title>");
  replace_all(svg, "<polygon fill", "<polygon shape-rendering='crispEdges' fill");
  return svg;
}

}  // namespace ballpit
