// SPDX-License-Identifier: MIT
#include "show/record_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/numbers.h"
#include "core/phrase.h"

namespace ballpit {

namespace {

using lecture::Action;
using lecture::Operation;
using lecture::RecordedRun;

/// With the sign for minus.
std::string typeset(const std::string& number) { return number.starts_with('-') ? "−" + number.substr(1) : number; }

/// The formula of slide 9 for a sphere: "⌊1.5⌋·5 + ⌊1.5⌋ = 6".
std::string hash_text(const RecordedRun& run, const Operation& operation) {
  const GridInspection& grid = *run.grid;
  const Vec3 place = run.places[static_cast<size_t>(operation.thread)];
  const auto whole = [&](int axis) {
    const float low = std::trunc(grid.origin[axis] / grid.edge[axis]);
    const std::string number = typeset(local_number(three_digits(place[axis] + (run.truncates ? low : 0))));
    return run.truncates ? fmt::format("(int({}) + {})", number, -low) : fmt::format("⌊{}⌋", number);
  };
  if (grid.cells.z > 1)
    return fmt::format("({}·{} + {})·{} + {} = {}", whole(2), grid.cells.y, whole(1), grid.cells.x, whole(0),
                       operation.value);
  return fmt::format("{}·{} + {} = {}", whole(1), grid.cells.x, whole(0), operation.value);
}

/// "thread 3"; in the sweep "thread b1", by the entry of the sorted list.
std::string thread_text(const RecordedRun& run, size_t k) {
  const Operation& operation = run.record.operations[k];
  const lecture::Phase& phase = run.phase_at(k);
  if (phase.name != "sweep") return phrase("thread {}", operation.thread);
  const std::vector<int> list = run.record.values_after(0, phase.first);
  return phrase("thread {}", value_text(run, list[static_cast<size_t>(operation.thread)]));
}

}  // namespace

std::string value_text(const RecordedRun& run, int value) {
  if (run.axis < 0) return typeset(std::to_string(value));
  return fmt::format("{}{}", value % 2 == 0 ? 'b' : 'e', value / 2);
}

std::string text_of(const RecordedRun& run, size_t k) {
  const Operation& operation = run.record.operations[k];
  const std::string thread = thread_text(run, k);
  const std::string element =
      operation.array < 0
          ? ""
          : fmt::format("{}[{}]", run.record.arrays[static_cast<size_t>(operation.array)].name, operation.index);
  const std::string value = value_text(run, operation.value);
  switch (operation.action) {
    case Action::compute:
      return phrase("{}: cell {}", thread, hash_text(run, operation));
    case Action::load:
      return phrase("{} loads {}: {}", thread, element, value);
    case Action::store:
      return phrase("{} stores {} = {}", thread, element, value);
    case Action::exchange:
      return phrase("{}: atomicExch(&{}, {}) returns {}", thread, element, value, value_text(run, operation.old_value));
    case Action::test:
      break;
  }
  const std::string outcome = translated(operation.value != 0 ? "contact" : "apart");
  return phrase("{} tests {} and {}: {}", thread, operation.index, operation.other, outcome);
}

CodeExcerpt function_at(std::string_view source, int line) {
  std::vector<std::string> lines;
  for (size_t start = 0; start < source.size();) {
    const size_t end = std::min(source.find('\n', start), source.size());
    lines.emplace_back(source.substr(start, end - start));
    start = end + 1;
  }
  const auto is_member = [&](int k) { return lines[static_cast<size_t>(k)].starts_with("  HOST_DEVICE"); };
  const auto is_comment = [&](int k) { return lines[static_cast<size_t>(k)].starts_with("  //"); };
  int first = line - 1, last = line - 1;
  const int count = static_cast<int>(lines.size());
  while (first > 0 && !is_member(first)) --first;
  while (first > 0 && is_comment(first - 1)) --first;
  while (last + 1 < count && lines[static_cast<size_t>(last)] != "  }") ++last;
  CodeExcerpt excerpt{first + 1, {}};
  for (int k = first; k <= last; ++k) {
    const std::string& text = lines[static_cast<size_t>(k)];
    excerpt.lines.push_back(text.substr(std::min<size_t>(2, text.size())));
  }
  return excerpt;
}

}  // namespace ballpit
