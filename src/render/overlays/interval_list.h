// SPDX-License-Identifier: MIT
// The sorted list of sort and sweep as a row of boxes, and the walk of one thread along it (slide 4).
//
//     ┌──┬───┬───┬───┬──┐
//     │b0│e0 │b1 │b2 │e1│    the begins that the thread meets are sky
//     └──┴─┬─┴─┬─┴───┴▲─┘
//          T   └──────┘      an arrow from the thread's begin to its end; other ends have a stub: their threads return
//                            at once. After the sweep all threads are shown, if they are few
#pragma once

#include "render/overlays/overlay.h"
#include "render/page_view.h"

namespace ballpit {

inline constexpr size_t kMaxLabels = 2 * 24;  ///< the endpoints of a longer list have no names
inline constexpr size_t kMaxWalks = 4;        ///< more threads are not shown at once

/// "b3" or "e3".
std::string name_of(const Endpoint& endpoint);

/// The boxes, at the picture's lower edge.
struct Row {
  float left, box, top, bottom;  ///< [pixel]
  bool is_stacked;               ///< names: the letter above the number

  Vec2 low(size_t k) const { return {left + static_cast<float>(k) * box, top}; }
  Vec2 high(size_t k) const { return {left + static_cast<float>(k + 1) * box, bottom}; }
  float middle(size_t k) const { return left + (static_cast<float>(k) + 0.5f) * box; }
};

/// [1/1080 of the picture's height] of the boxes and the walk below them.
float list_height(size_t entries, float text_scale);

/// Room for the list, if its names fit. The row is under `middle` [pixel], as far as it fits into the picture.
std::optional<Row> take_row(const std::vector<Endpoint>& endpoints, float middle, Painter& painter);

/// The walk of the picked body, or else the longest; after the sweep those of all bodies, if they are few. None while no
/// thread walks yet.
std::vector<Walk> shown_walks(const std::vector<Endpoint>& endpoints, int64_t selected, const PageView* page);

/// The walks of several bodies are drawn at a few levels below the list.
void draw_list(const std::vector<Endpoint>& endpoints, const std::vector<Walk>& walks, const Row& row,
               const PageView* page, Painter& painter);

}  // namespace ballpit
