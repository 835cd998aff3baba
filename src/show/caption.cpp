// SPDX-License-Identifier: MIT
#include "show/caption.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/language.h"
#include "core/numbers.h"
#include "measure/machine.h"
#include "measure/statistics.h"

namespace ballpit {

namespace {

using lecture::Action;
using lecture::Operation;

int64_t pairs_of(int64_t spheres) { return spheres * (spheres - 1) / 2; }

/// The operations of the run so far that `counts` accepts; empty without a run.
template <class Counts>
std::string count_operations(const PageState& state, const Counts& counts) {
  if (state.run == nullptr) return "";
  const std::vector<Operation>& operations = state.run->record.operations;
  const auto end = operations.begin() + static_cast<std::ptrdiff_t>(std::min(state.cursor, operations.size()));
  return grouped(std::count_if(operations.begin(), end, counts));
}

/// Particles that no list holds after the whole run.
std::string lost_particles(const PageState& state) {
  if (state.run == nullptr || state.run->kernel < lecture::KernelName::linked_cell) return "";
  const size_t all = state.run->record.operations.size();
  const std::vector<int> head = state.run->record.values_after(0, all), next = state.run->record.values_after(1, all);
  int64_t lost = static_cast<int64_t>(next.size());
  for (int i : head) {
    for (; i >= 0; i = next.at(static_cast<size_t>(i))) --lost;
  }
  return grouped(lost);
}

/// A page with a kernel counts its contacts: those that its tests have found so far.
std::string contacts_found(const PageState& state) {
  if (state.run == nullptr) return grouped(state.report.contacts);
  return count_operations(state, [](const Operation& o) { return o.action == Action::test && o.value != 0; });
}

double longest_leap(const PageState& state) {
  const BodySnapshot& bodies = state.inspection.bodies;
  double longest = 0;
  for (int64_t i = 0; i < bodies.count && !bodies.velocity.empty(); ++i) {
    longest = std::max(longest, double(length(bodies.velocity_of(i))) * state.step / (2.0 * bodies.radius_of(i)));
  }
  return longest;
}

/// Three digits, or a whole number with its thousands apart.
std::string figure(double value) {
  constexpr double kLarge = 1000;
  return value >= kLarge ? grouped(std::llround(value)) : three_digits(value);
}

std::string times_fewer(const PageState& state) {
  if (state.report.candidates == 0) return "";
  return figure(double(pairs_of(state.report.count)) / double(state.report.candidates));
}

/// Pairs that the kernel finds although they do not touch.
std::string invented_contacts(const PageState& state) {
  if (state.run == nullptr || state.cursor < state.run->record.operations.size()) return "";
  std::vector<Pair> found = state.inspection.contacts;
  found.erase(std::unique(found.begin(), found.end()), found.end());
  const auto missed = static_cast<int64_t>(state.inspection.missed.size());
  return grouped(static_cast<int64_t>(found.size()) - (state.contacts - missed));
}

std::string this_machine(const PageState& state) { return state.race ? cpu_model() : ""; }

}  // namespace

const std::vector<Placeholder>& placeholder_table() {
  static const std::vector<Placeholder> table{
      {"spheres", "number of spheres", [](const PageState& s) { return grouped(s.report.count); }},
      {"pairs", "all pairs of spheres, n(n−1)/2", [](const PageState& s) { return grouped(pairs_of(s.report.count)); }},
      {"entries", "begins and ends, 2n", [](const PageState& s) { return grouped(2 * s.report.count); }},
      {"candidates", "pairs that the broad phase leaves to be tested",
       [](const PageState& s) { return grouped(s.report.candidates); }},
      {"fewer", "how many times fewer these are than all pairs", times_fewer},
      {"contacts", "contacts found, with a kernel those up to the cursor", contacts_found},
      {"missed", "contacts that the method misses",
       [](const PageState& s) { return grouped(static_cast<int64_t>(s.inspection.missed.size())); }},
      {"all", "contacts that there are", [](const PageState& s) { return grouped(s.contacts); }},
      {"invented", "pairs that the kernel finds although they do not touch", invented_contacts},
      {"cells", "cells of the grid",
       [](const PageState& s) -> std::string {
         if (s.inspection.grids.empty()) return "";
         const IVec3& cells = s.inspection.grids.front().cells;
         return grouped(int64_t(cells.x) * cells.y * cells.z);
       }},
      {"operations", "operations of the kernel up to the cursor",
       [](const PageState& s) { return count_operations(s, [](const Operation&) { return true; }); }},
      {"tests", "tests of the kernel up to the cursor",
       [](const PageState& s) {
         return count_operations(s, [](const Operation& o) { return o.action == Action::test; });
       }},
      {"moves", "entries that the kernel has moved up to the cursor",
       [](const PageState& s) {
         const auto is_move = [](const Operation& o) {
           return o.action == Action::store && o.old_value != lecture::kUnset;
         };
         return count_operations(s, is_move);
       }},
      {"lost", "spheres that are in no list after the kernel", lost_particles},
      {"lost_by_threads", "spheres that are lost when real threads race",
       [](const PageState& s) { return s.race ? grouped(s.race->lost) : ""; }},
      {"racing", "spheres that they insert", [](const PageState&) { return grouped(kRacing); }},
      {"threads", "their number", [](const PageState& s) { return s.race ? grouped(s.race->threads) : ""; }},
      {"machine", "their processor", this_machine},
      {"busy", "share of lanes that are busy, in percent",
       [](const PageState& s) -> std::string {
         const std::optional<double> share = profile_work(s.inspection.work).simd_efficiency;
         return share ? figure(100 * *share) : "";
       }},
      {"steps", "entries of lists that all threads read together",
       [](const PageState& s) -> std::string {
         const std::vector<int>& work = s.inspection.work;
         return work.empty() ? "" : grouped(std::accumulate(work.begin(), work.end(), int64_t{0}));
       }},
      {"overlap", "largest overlap, in percent of a radius",
       [](const PageState& s) { return figure(100 * s.report.max_overlap); }},
      {"leap", "longest path in a step, in diameters of its sphere",
       [](const PageState& s) { return figure(longest_leap(s)); }},
      {"searches", "searches for contacts in a simulated second",
       [](const PageState& s) { return grouped(std::llround(1 / s.step)); }},
      {"energy", "energy, in percent of that at the start", [](const PageState& s) { return figure(100 * s.energy); }},
      {"time", "simulated seconds", [](const PageState& s) { return figure(s.report.time); }},
  };
  return table;
}

std::string unknown_placeholder(std::string_view text) {
  for (size_t at = text.find('{'); at != text.npos; at = text.find('{', at + 1)) {
    const size_t end = std::min(text.find('}', at), text.size() - 1);
    const std::string_view name = text.substr(at + 1, end - at - 1);
    const auto& table = placeholder_table();
    if (std::none_of(table.begin(), table.end(), [&](const Placeholder& p) { return p.name == name; })) {
      return std::string(text.substr(at, end - at + 1));
    }
  }
  return "";
}

std::string fill_caption(std::string_view text, const PageState& state, const Figures& stored) {
  std::string result(text);
  for (const Placeholder& placeholder : placeholder_table()) {
    const std::string name = fmt::format("{{{}}}", placeholder.name);
    for (size_t at = result.find(name); at != std::string::npos; at = result.find(name, at)) {
      std::string figure = local_number(placeholder.figure(state));
      if (const auto kept = stored.find(placeholder.name); figure.empty() && kept != stored.end()) {
        figure = kept->second;
      }
      result.replace(at, name.size(), figure.empty() ? "?" : figure);
    }
  }
  return result;
}

}  // namespace ballpit
