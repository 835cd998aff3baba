// SPDX-License-Identifier: MIT
// Captions of lecture pages: sentences whose figures, {names}, are counted when the page is shown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lecture/recorded_run.h"
#include "world/world.h"

namespace ballpit {

/// What a page shows.
struct PageState {
  const Report& report;
  const Inspection& inspection;
  const lecture::RecordedRun* run = nullptr;  ///< of its kernel
  size_t cursor = 0;                          ///< operations of the run so far
  double step = 0;                            ///< [s] until the next search
};

/// One {name}; its figure is empty where the page lacks the data.
struct Placeholder {
  std::string_view name;
  std::string_view meaning;
  std::string (*figure)(const PageState&);
};

const std::vector<Placeholder>& placeholder_table();

/// The first {name} in `text` that is not in the table; empty if there is none.
std::string unknown_placeholder(std::string_view text);

/// `text` with the figures of `state`; "?" where the page lacks the data.
std::string fill_caption(std::string_view text, const PageState& state);

}  // namespace ballpit
