// SPDX-License-Identifier: MIT
// Draws the list that sort-and-sweep sorts, as a row of boxes at the picture's lower edge (slide 4), and one thread's walk.
//
//           ┌─────────┐   T         an arrow from the thread's begin to its end; the begins that it
//     ┌──┬──┴──┬──┬───▼┬──┐         meets are sky; ends are grey: their threads return at once
//     │b0│ b1  │b2│ e1 │e0│
//     └──┴─────┴──┴────┴──┘
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "broad_phase/inspection.h"
#include "render/painter.h"

namespace ballpit {

/// The endpoints of a longer list have no names.
inline constexpr size_t kMaxLabels = 2 * 24;

/// "b3" or "e3".
std::string name_of(const Endpoint& endpoint);

/// A thread's walk along the sorted list: from a begin to the end of the same body.
struct Walk {
  int body = -1;
  size_t first = 0, last = 0;  ///< entries of the list
  std::vector<size_t> met;     ///< the begins between them, which the thread tests
};

/// The walk of the selected body; without a selection, the walk with the most tests. Its body is −1 if there is none.
Walk shown_walk(const std::vector<Endpoint>& endpoints, int64_t selected);

struct Row {
  float left, box, top, bottom;  // [pixel]

  Vec2 low(size_t k) const { return {left + static_cast<float>(k) * box, top}; }
  Vec2 high(size_t k) const { return {left + static_cast<float>(k + 1) * box, bottom}; }
  float middle(size_t k) const { return left + (static_cast<float>(k) + 0.5f) * box; }
};

/// Room for the list, if its names fit.
std::optional<Row> take_row(const std::vector<Endpoint>& endpoints, Painter& painter);

void draw_list(const std::vector<Endpoint>& endpoints, const Walk& walk, const Row& row, Painter& painter);

}  // namespace ballpit
