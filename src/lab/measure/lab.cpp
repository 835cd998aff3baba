// SPDX-License-Identifier: MIT
#include "lab/measure/lab.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "core/file.h"
#include "core/interrupt.h"
#include "lab/charts/chart.h"
#include "lab/charts/table.h"
#include "measure/machine.h"
#include "version.h"

namespace ballpit {

namespace {

double number_in(const std::string& cell) {
  double value = kNoNumber;  // an empty cell
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

double load_average() {
  double load = 0;
  return ::getloadavg(&load, 1) == 1 ? load : 0;
}

}  // namespace

Lab::Lab(LabOptions options) : options_(std::move(options)) {
  if (options_.cache.empty()) return;
  append_to_file(options_.cache, "");  // fails now, not after the first measurement
  const std::string text = read_file(options_.cache);
  size_t start = 0;
  for (size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1) {
    const std::vector<std::string> cells = split_csv_line(std::string_view(text).substr(start, end - start));
    std::vector<double>& values = kept_[cells.front()];
    values.clear();
    for (size_t k = 1; k < cells.size(); ++k) values.push_back(number_in(cells[k]));
  }
  // An incomplete last line comes from a full disk or a crash.
  if (start < text.size()) shorten_file(options_.cache, static_cast<int64_t>(start));
}

std::vector<double> Lab::measure(const std::string& key, const std::function<std::vector<double>()>& function) {
  if (options_.stop && options_.stop()) stop();
  const std::string full_key = fmt::format("ballpit {}; {}", kVersion, key);
  const auto found = kept_.find(full_key);
  const bool was_kept = found != kept_.end();
  std::vector<double> values;
  try {
    values = was_kept ? found->second : function();
  } catch (const Interrupted&) {
    stop();
  }
  if (!was_kept) {
    keep(full_key, values);
    ++measured_;
  }
  ++asked_;
  if (options_.tell) options_.tell(was_kept);
  return values;
}

std::vector<double> Lab::time(const std::string& key, const std::function<std::vector<double>()>& function) {
  std::vector<double> values = measure(key + "; " + machine_line(), [&] {
    std::vector<double> seconds = function();
    seconds.push_back(load_average());
    return seconds;
  });
  if (values.empty()) throw RunError(options_.cache.string(), "holds a timing without numbers", "remove the file");
  load_ = std::max(load_, values.back());
  values.pop_back();
  return values;
}

void Lab::stop() const {
  throw RunError(options_.name,
                 fmt::format("interrupted after {} measurements of this experiment, which are kept", asked_),
                 "the same command goes on from there");
}

void Lab::keep(const std::string& key, const std::vector<double>& values) {
  kept_[key] = values;
  if (options_.cache.empty()) return;
  std::vector<Cell> cells{key};
  cells.insert(cells.end(), values.begin(), values.end());
  append_to_file(options_.cache, csv_line(cells));
}

}  // namespace ballpit
