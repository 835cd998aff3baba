// SPDX-License-Identifier: MIT
// The report: one HTML page that holds all of its charts, for a phone as for a projector, light and dark as the reader's
// system has it; and the same story in Markdown, for a repository's pages.
#pragma once

#include <string>
#include <vector>

#include "lab/report/experiment.h"

namespace ballpit {

/// A chart as SVG on both grounds.
struct DrawnChart {
  std::string name;
  std::string title;
  std::string light, dark;
};

/// An experiment, what it found, and its charts; none where there is no gnuplot.
struct ReportSection {
  const Experiment* experiment;
  Findings findings;
  std::vector<DrawnChart> charts;
  std::string command;  ///< that repeats it
};

/// `circumstances`: machine, preset and so on, a line each. `lack`: what is missing, and why; empty where nothing is.
std::string report_html(const std::vector<ReportSection>& sections, const std::vector<std::string>& circumstances,
                        const std::string& lack);

/// The same as Markdown, with the charts as links to "NAME/CHART.svg".
std::string report_markdown(const std::vector<ReportSection>& sections, const std::vector<std::string>& circumstances,
                            const std::string& lack);

}  // namespace ballpit
