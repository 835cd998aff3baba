// SPDX-License-Identifier: MIT
// The report of the laboratory: one HTML page that contains all its charts, readable on a phone and on a projector,
// light or dark as the reader's system is set; and the same in Markdown, for a repository's pages.
#pragma once

#include "lab/report/experiment.h"

namespace ballpit {

/// A chart as SVG on both backgrounds.
struct DrawnChart {
  std::string name;
  std::string title;
  std::string light, dark;
};

/// An experiment, its findings and its charts. Without gnuplot there are no charts.
struct ReportSection {
  const Experiment* experiment;
  Findings findings;
  std::vector<DrawnChart> charts;
  std::string command;  ///< repeats it
};

/// Under which an experiment ran: the machine, the preset and so on.
struct Circumstance {
  std::string name, value;
};

/// In the language set. `lack`: what is missing and why; empty if nothing is.
std::string report_html(const std::vector<ReportSection>& sections, const std::vector<Circumstance>& circumstances,
                        const std::string& lack);

/// The same in Markdown, with the charts as links to "NAME/CHART.svg".
std::string report_markdown(const std::vector<ReportSection>& sections, const std::vector<Circumstance>& circumstances,
                            const std::string& lack);

/// The chart with all its texts in the language set.
Chart in_language_set(Chart chart);

/// "data:image/svg+xml;base64,…": the address of a picture that the page itself contains.
std::string svg_address(std::string_view svg);

}  // namespace ballpit
