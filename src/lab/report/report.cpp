// SPDX-License-Identifier: MIT
#include "lab/report/report.h"

#include <initializer_list>
#include <string_view>

#include "lab/charts/html.h"

namespace ballpit {

namespace {

// Text is as large on a projector as the last row needs, and fits a phone; a table wider than that scrolls by itself.
constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Ballpit: the laboratory's report</title>
<style>
:root { --ground: #FFFFFF; --text: #1A1A1A; --faint: #DDE1E6; --quiet: #5F6368; --link: #0072B2; }
@media (prefers-color-scheme: dark) {
  :root { --ground: #14171C; --text: #E8EAED; --faint: #343A43; --quiet: #9AA0A6; --link: #56B4E9; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 0 clamp(14px, 3vw, 56px) 4em; max-width: 1840px; background: var(--ground); color: var(--text);
  font: clamp(16px, 0.55vw + 13px, 24px)/1.5 Roboto, "Helvetica Neue", Arial, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.9em; line-height: 1.2; margin: 1em 0 0.3em; }
h2 { font-size: 1.45em; line-height: 1.25; margin: 0 0 0.2em; }
p { max-width: 70ch; margin: 0.5em 0; }
a { color: var(--link); }
section { border-top: 2px solid var(--faint); margin-top: 2.2em; padding-top: 1.4em; }
.quiet { color: var(--quiet); font-size: 0.85em; margin: 0.2em 0; }
.answer { font-weight: 600; font-size: 1.1em; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 660px), 1fr)); gap: 1em 2em; margin: 1em 0; }
figure { margin: 0; }
figure img { display: block; width: 100%; height: auto; max-width: 960px; }
@media (max-width: 700px) {
  .charts { margin: 0.8em -14px; }
  .contents td { display: block; border: 0; padding: 0; }
  .contents td + td { padding-bottom: 0.8em; }
}
.scroll { overflow-x: auto; }
.scroll th, .scroll td { white-space: nowrap; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin: 0.8em 0; }
th, td { text-align: left; vertical-align: top; padding: 0.3em 0.9em 0.3em 0; border-bottom: 1px solid var(--faint); }
td.number, th.number { text-align: right; }
code { font-size: 0.9em; overflow-wrap: anywhere; }
</style>
</head>
<body>
)";

/// One text of many, without copies of what is half done.
std::string concat(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

std::string paragraph(std::string_view kind, std::string_view text) {
  return concat({"<p class=\"", kind, "\">", html_text(text), "</p>\n"});
}

std::string link(std::string_view address, std::string_view text) {
  return concat({"<a href=\"", html_text(address), "\">", html_text(text), "</a>"});
}

/// What was found, at a glance: a line an experiment.
std::string contents(const std::vector<ReportSection>& sections) {
  std::string text = "<table class=\"contents\">\n";
  for (const ReportSection& section : sections) {
    const Experiment& experiment = *section.experiment;
    text += concat({"<tr><td>", link(concat({"#", experiment.name}), experiment.title), "</td><td>",
                    html_text(section.findings.answer), "</td></tr>\n"});
  }
  return text + "</table>\n";
}

std::string figure(const DrawnChart& chart) {
  return concat({"<figure><picture><source media=\"(prefers-color-scheme: dark)\" srcset=\"", svg_address(chart.dark),
                 "\"><img alt=\"", html_text(chart.title), "\" width=\"720\" height=\"520\" src=\"",
                 svg_address(chart.light), "\"></picture></figure>\n"});
}

std::string cell(const Cell& value) {
  const bool is_number = std::holds_alternative<double>(value);
  return concat({is_number ? "<td class=\"number\">" : "<td>", html_text(short_text(value)), "</td>"});
}

std::string table_html(const Table& table) {
  std::string text = "<div class=\"scroll\"><table>\n<tr>";
  for (size_t k = 0; k < table.columns.size(); ++k) {
    const bool is_number = !table.rows.empty() && std::holds_alternative<double>(table.rows[0][k]);
    text += concat({is_number ? "<th class=\"number\">" : "<th>", html_text(header_of(table.columns[k])), "</th>"});
  }
  text += "</tr>\n";
  for (const std::vector<Cell>& row : table.rows) {
    text += "<tr>";
    for (const Cell& value : row) text += cell(value);
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

std::string section_html(const ReportSection& section) {
  const Experiment& experiment = *section.experiment;
  const Findings& findings = section.findings;
  std::string text = concat({"<section id=\"", experiment.name, "\">\n<h2>", html_text(experiment.title), "</h2>\n<p>",
                             html_text(experiment.question), "</p>\n", paragraph("answer", findings.answer)});
  if (!section.charts.empty()) {
    text += "<div class=\"charts\">\n";
    for (const DrawnChart& chart : section.charts) text += figure(chart);
    text += "</div>\n";
  }
  for (const Table& table : findings.tables) {
    if (table.is_shown) text += table_html(table);
  }
  text += concat({"<p>", html_text(findings.see), "</p>\n<p class=\"quiet\">To repeat it: <code>",
                  html_text(section.command), "</code>. Data:"});
  for (const Table& table : findings.tables) {
    const std::string file = table.name + ".csv";
    text += concat({" ", link(concat({experiment.name, "/", file}), file)});
  }
  return text + "</p>\n</section>\n";
}

}  // namespace

std::string report_html(const std::vector<ReportSection>& sections, const std::vector<std::string>& circumstances,
                        const std::string& lack) {
  std::string text = std::string(kHead) + "<h1>Ballpit: the laboratory’s report</h1>\n";
  for (const std::string& line : circumstances) text += paragraph("quiet", line);
  if (!lack.empty()) text += paragraph("answer", lack);
  text += contents(sections);
  for (const ReportSection& section : sections) text += section_html(section);
  return text + "</body>\n</html>\n";
}

}  // namespace ballpit
