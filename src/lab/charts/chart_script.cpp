// SPDX-License-Identifier: MIT
#include "lab/charts/chart_script.h"

#include "scene/input_error.h"

namespace ballpit {

void ChartScript::write_text(double x, double y, const std::string& text, Rgb color, const std::string& where,
                             int size) {
  line("set label " + quoted_text(text) + " at screen " + number_text(x) + ", screen " + number_text(y) + ' ' + where +
       " font '," + std::to_string(size) + "' textcolor " + rgb(color));
}

std::string ChartScript::block(const std::string& lines) {
  const std::string name = "$d" + std::to_string(++blocks_);
  data_ += name + " << EOD\n" + lines + "EOD\n";
  return name;
}

std::string quoted_text(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    result += c;
    if (c == '\'') result += c;
  }
  return result + '\'';
}

std::string rgb(Rgb color) { return "rgb '" + hex(color) + "'"; }

}  // namespace ballpit
