// SPDX-License-Identifier: MIT
// Captions of lecture pages: sentences whose figures, {names}, are counted when the page is shown.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lecture/real_race.h"
#include "lecture/recorded_run.h"
#include "methods/choices.h"
#include "world/world.h"

namespace ballpit {

/// What a page shows.
struct PageState {
  const Report& report;
  const Inspection& inspection;
  int64_t contacts = 0;                       ///< all that there are
  const lecture::RecordedRun* run = nullptr;  ///< of its kernel
  size_t cursor = 0;                          ///< operations of the run so far
  double step = 0;                            ///< [s] until the next search
  double energy = 1;                          ///< of that at the start
  std::optional<lecture::RealRace> race{};    ///< if it was run
};

/// Figures by their names.
using Figures = std::map<std::string, std::string, std::less<>>;

/// One {name}; its figure is empty where the page lacks the data.
struct Placeholder {
  std::string_view name;
  std::string_view meaning;
  std::string (*figure)(const PageState&);
};

const std::vector<Placeholder>& placeholder_table();

/// The first {name} in `text` that is not in the table; empty if there is none.
std::string unknown_placeholder(std::string_view text);

/// The spheres that race on threads for {lost_by_threads}.
inline constexpr int64_t kRacing = 1'000'000;

/// `text` with the figures of `state`; where the page lacks the data, those stored, or "?".
std::string fill_caption(std::string_view text, const PageState& state, const Figures& stored = {});

}  // namespace ballpit
