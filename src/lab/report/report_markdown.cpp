// SPDX-License-Identifier: MIT
#include <string_view>

#include "lab/report/report.h"

namespace ballpit {

namespace {

/// Text that means nothing but itself, in one line of a table as well.
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("\\`*_<|[]&~$").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line.append(" ").append(cell).append(" |");
  return line + "\n";
}

std::string table_markdown(const Table& table) {
  std::vector<std::string> headers, rules;
  for (size_t k = 0; k < table.columns.size(); ++k) {
    const bool is_number = !table.rows.empty() && std::holds_alternative<double>(table.rows[0][k]);
    headers.push_back(plain(header_of(table.columns[k])));
    rules.push_back(is_number ? "--:" : "---");
  }
  std::string text = "\n";
  text.append(row(headers)).append(row(rules));
  for (const std::vector<Cell>& cells : table.rows) {
    std::vector<std::string> texts;
    for (const Cell& cell : cells) texts.push_back(plain(short_text(cell)));
    text += row(texts);
  }
  return text;
}

std::string section_markdown(const ReportSection& section) {
  const std::string name(section.experiment->name);
  std::string text = "\n## " + plain(section.experiment->title) + "\n\n" + plain(section.experiment->question) +
                     "\n\n**" + plain(section.findings.answer) + "**\n";
  for (const DrawnChart& chart : section.charts) {
    text.append("\n![").append(plain(chart.title)).append("](").append(name).append("/");
    text.append(chart.name).append(".svg)\n");
  }
  for (const Table& table : section.findings.tables) {
    if (table.is_shown) text += table_markdown(table);
  }
  text.append("\n").append(plain(section.findings.see)).append("\n\nTo repeat it: `");
  return text.append(section.command).append("`\n");
}

}  // namespace

std::string report_markdown(const std::vector<ReportSection>& sections, const std::vector<std::string>& circumstances,
                            const std::string& lack) {
  std::string text = "# Ballpit: the laboratory’s report\n\n";
  for (const std::string& line : circumstances) text.append("- ").append(plain(line)).append("\n");
  if (!lack.empty()) text.append("\n**").append(plain(lack)).append("**\n");
  text.append("\n").append(row({"experiment", "what it found"})).append(row({"---", "---"}));
  for (const ReportSection& section : sections) {
    text += row({plain(section.experiment->title), plain(section.findings.answer)});
  }
  for (const ReportSection& section : sections) text += section_markdown(section);
  return text;
}

}  // namespace ballpit
