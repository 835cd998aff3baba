// SPDX-License-Identifier: MIT
#include "lab/charts/gnuplot.h"

#include "core/error.h"
#include "core/program.h"
#include "lab/charts/chart_script.h"

namespace ballpit {

std::string html_text(std::string_view text) {
  const std::string tags = replaced(replaced(replaced(std::string(text), "&", "&amp;"), "<", "&lt;"), ">", "&gt;");
  return replaced(tags, "\"", "&quot;");
}

std::string gnuplot_path() { return find_program("gnuplot"); }

std::string draw_svg(const Chart& chart, Ground ground, const std::string& gnuplot) {
  ProgramCall call{gnuplot, {"--default-settings"}};  // ignores the user's settings
  call.input = gnuplot_script(chart, ground);
  call.gets_interrupts = false;  // Ctrl-C ends the laboratory after the current chart
  const ProgramResult result = call_program(call);
  if (result.status != 0 || result.output.find("</svg>") == std::string::npos) {
    throw RunError(gnuplot, "failed on chart " + chart.name + ": " + result.errors);
  }
  // gnuplot accepts one font family only. Without crisp edges, the background shows between the cells of a map.
  const std::string fonts = replaced(result.output, "font-family=\"sans-serif\"",
                                     "font-family=\"Roboto, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif\"");
  const std::string titled = replaced(fonts, "<title>Gnuplot</title>", "<title>" + html_text(chart.title) + "</title>");
  return replaced(titled, "<polygon fill", "<polygon shape-rendering='crispEdges' fill");
}

}  // namespace ballpit
