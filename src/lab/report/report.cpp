// SPDX-License-Identifier: MIT
#include "lab/report/report.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "core/language.h"
#include "lab/charts/chart_script.h"
#include "lab/charts/gnuplot.h"
#include "methods/choices.h"
#include "report_files.h"

namespace ballpit {

namespace {

/// How a format writes each part of the report: patterns for fmt::format. Comments name the arguments of a pattern.
struct Format {
  std::string (*escape)(std::string_view text);
  std::string (*escape_code)(std::string_view text);
  const char* title;                          // text
  const char* circumstance;                   // name, value
  const char* paragraph;                      // text
  const char* emphasis;                       // text
  const char* contents;                       // lines, "experiment", "what it found"
  const char* contents_line;                  // experiment, title, answer
  const char* heading;                        // experiment, title
  const char* charts;                         // charts
  const char* chart;                          // experiment, chart, title, light picture, dark picture
  const char* table;                          // header, rules, rows
  const char* row;                            // cells
  const char *header[2], *rule[2], *cell[2];  // of text columns and of number columns: text
  const char* section_end;                    // "To repeat it", command, "Data", data
  const char* data;                           // experiment, table
  const char* end;
};

constexpr Format kHtml{
    .escape = html_text,
    .escape_code = html_text,
    .title = "<h1>{}</h1>\n",
    .circumstance = "<p class=\"quiet\">{}: {}</p>\n",
    .paragraph = "<p>{}</p>\n",
    .emphasis = "<p class=\"answer\">{}</p>\n",
    .contents = "<table class=\"contents\">\n{}</table>\n",
    .contents_line = "<tr><td><a href=\"#{}\">{}</a></td><td>{}</td></tr>\n",
    .heading = "<section id=\"{}\">\n<h2>{}</h2>\n",
    .charts = "<div class=\"charts\">\n{}</div>\n",
    .chart =
        "<figure><picture><source media=\"(prefers-color-scheme: dark)\" srcset=\"{4}\">"
        "<img alt=\"{2}\" width=\"720\" height=\"520\" src=\"{3}\"></picture></figure>\n",
    .table = "<div class=\"scroll\"><table>\n<tr>{0}</tr>\n{2}</table></div>\n",
    .row = "<tr>{}</tr>\n",
    .header = {"<th>{}</th>", "<th class=\"number\">{}</th>"},
    .rule = {"", ""},
    .cell = {"<td>{}</td>", "<td class=\"number\">{}</td>"},
    .section_end = "<p class=\"quiet\">{}: <code>{}</code>. {}:{}</p>\n</section>\n",
    .data = " <a href=\"{0}/{1}.csv\">{1}.csv</a>",
    .end = "</body>\n</html>\n",
};

/// Text without special meaning in Markdown, also inside a table.
std::string markdown_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("\\`*_<|[]&~$").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

constexpr Format kMarkdown{
    .escape = markdown_text,
    .escape_code = [](std::string_view text) { return std::string(text); },
    .title = "# {}\n\n",
    .circumstance = "- {}: {}\n",
    .paragraph = "\n{}\n",
    .emphasis = "\n**{}**\n",
    .contents = "\n| {1} | {2} |\n| --- | --- |\n{0}",
    .contents_line = "| {1} | {2} |\n",
    .heading = "\n## {1}\n",
    .charts = "{}",
    .chart = "\n![{2}]({0}/{1}.svg)\n",
    .table = "\n|{0}\n|{1}\n{2}",
    .row = "|{}\n",
    .header = {" {} |", " {} |"},
    .rule = {" --- |", " --: |"},
    .cell = {" {} |", " {} |"},
    .section_end = "\n{}: `{}`\n",
    .data = "",
    .end = "",
};

template <class... Parts>
std::string fill(const char* pattern, const Parts&... parts) {
  return fmt::format(fmt::runtime(pattern), parts...);
}

/// A short text in the language set, with its numbers.
std::string shown(const std::string& text) { return local_number(translated(text)); }

std::string text_of(const Format& format, const Table& table) {
  std::string header, rules, rows;
  for (size_t k = 0; k < table.columns.size(); ++k) {
    const bool is_number = !table.rows.empty() && std::holds_alternative<double>(table.rows[0][k]);
    header += fill(format.header[is_number], format.escape(shown(table.columns[k])));
    rules += format.rule[is_number];
  }
  for (const std::vector<Cell>& row : table.rows) {
    std::string cells;
    for (const Cell& cell : row) {
      cells += fill(format.cell[std::holds_alternative<double>(cell)], format.escape(shown(short_text(cell))));
    }
    rows += fill(format.row, cells);
  }
  return fill(format.table, header, rules, rows);
}

std::string text_of(const Format& format, const ReportSection& section) {
  const Experiment& experiment = *section.experiment;
  const ExperimentText text = experiment.text();
  std::string charts, tables, data;
  for (const DrawnChart& chart : section.charts) {
    charts += fill(format.chart, experiment.name, chart.name, format.escape(chart.title), svg_address(chart.light),
                   svg_address(chart.dark));
  }
  if (!charts.empty()) charts = fill(format.charts, charts);
  for (const Table& table : section.findings.tables) {
    if (table.is_shown) tables += text_of(format, table);
    data += fill(format.data, experiment.name, format.escape(table.name));
  }
  return fill(format.heading, experiment.name, format.escape(text.title)) +
         fill(format.paragraph, format.escape(text.question)) +
         fill(format.emphasis, format.escape(section.findings.answer)) + charts + tables +
         fill(format.paragraph, format.escape(section.findings.see)) +
         fill(format.section_end, translated("To repeat it"), format.escape_code(section.command), translated("Data"),
              data);
}

std::string report(const Format& format, const std::vector<ReportSection>& sections,
                   const std::vector<Circumstance>& circumstances, const std::string& lack) {
  std::string text = fill(format.title, translated("Ballpit: the laboratory’s report")), contents, results;
  for (const auto& [name, value] : circumstances) {
    text += fill(format.circumstance, format.escape(translated(name)), format.escape(translated(value)));
  }
  if (!lack.empty()) text += fill(format.emphasis, format.escape(lack));
  for (const ReportSection& section : sections) {
    const Experiment& experiment = *section.experiment;
    contents += fill(format.contents_line, experiment.name, format.escape(experiment.text().title),
                     format.escape(section.findings.answer));
    results += text_of(format, section);
  }
  return text + fill(format.contents, contents, translated("experiment"), translated("what it found")) + results +
         format.end;
}

}  // namespace

std::string report_html(const std::vector<ReportSection>& sections, const std::vector<Circumstance>& circumstances,
                        const std::string& lack) {
  const std::string head = replaced(std::string(report_files().front().text), "{lang}", name_of(language()));
  return replaced(head, "{title}", html_text(translated("Ballpit: the laboratory’s report"))) +
         report(kHtml, sections, circumstances, lack);
}

std::string report_markdown(const std::vector<ReportSection>& sections, const std::vector<Circumstance>& circumstances,
                            const std::string& lack) {
  return report(kMarkdown, sections, circumstances, lack);
}

Chart in_language_set(Chart chart) {
  const auto set = [](std::string& text) { text = shown(text); };
  set(chart.title);
  for (Axis* axis : {&chart.x, &chart.y}) set(axis->label), set(axis->unit);
  for (Series& series : chart.series) set(series.label);
  for (Bound& bound : chart.bounds) set(bound.label);
  if (!chart.map) return chart;
  set(chart.map->colors.label);
  for (Category& category : chart.map->categories) set(category.label);
  return chart;
}

std::string svg_address(std::string_view svg) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result = "data:image/svg+xml;base64,";
  for (size_t k = 0; k < svg.size(); k += 3) {
    uint32_t bits = 0;
    const size_t size = std::min<size_t>(3, svg.size() - k);
    for (size_t b = 0; b < 3; ++b) bits = bits << 8 | (b < size ? static_cast<uint8_t>(svg[k + b]) : 0u);
    for (size_t d = 0; d < 4; ++d) result += d <= size ? kDigits[bits >> (18 - 6 * d) & 63u] : '=';
  }
  return result;
}

}  // namespace ballpit
