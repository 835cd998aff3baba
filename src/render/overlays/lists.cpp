// SPDX-License-Identifier: MIT
// Shows the arrays in which a method stores its cells. Linked lists (slides 12 to 15): per cell the first body, per
// body the next one.
//
//             0    1    2    3    4
//     head  │ −1 │  2 │ −1 │ −1 │ −1 │      cell 1 holds bodies 2 and 0
//                  │
//             0    ▼ 1    2
//     next  │ −1 │ −1 │  0 │                drawn: head[1] → 2, and 2 → 0 in an arc below
//             ▲─────────╯
//
// Sorted by cell: per cell the begin of its range of bodies; the last entry is the end of the last range.
//
//               0    1    2    3
//     offsets │  0 │  0 │  2 │  3 │         cell 1 holds bodies 4 and 0
//                     │
//               0     ▼ 1    2
//     bodies  │  4 │  0 │  7 │
//              └───────┘
//
// A hashed grid has the slots of a table instead of cells, and cells share slots. So each body has its key below it,
// the index of its cell, by which the search tells the cells of a slot apart:
//
//               0    1    2
//     next    │ −1 │ −1 │  0 │              bodies 2 and 0 share a slot, but not a cell
//     cell    │  7 │  3 │ 19 │
//
// Of many cells or slots, only the occupied ones are shown. If they or the bodies do not fit in a row, a histogram
// shows the lengths of the lists or ranges instead.
#include <numeric>

#include <fmt/format.h>

#include "core/phrase.h"
#include "lecture/record.h"
#include "render/overlays/overlay.h"
#include "render/page_view.h"

namespace ballpit {

namespace {

constexpr size_t kMaxBoxes = 32;
constexpr size_t kMaxLength = 10;
// [1/1080 of the picture's height]
constexpr float kListMargin = 12, kPadding = 3, kListGap = 58, kArcs = 44, kWidest = 140;

/// One array: numbered boxes beside its name.
struct Boxes {
  float left, width, top, height, number;  // [pixel]; `number`: height of the line above with the indices

  float middle(size_t k) const { return left + (static_cast<float>(k) + 0.5f) * width; }
  Vec2 over_number(size_t k) const { return {middle(k), top - number}; }
  Vec2 under(size_t k) const { return {middle(k), top + height}; }
};

/// The arrays of the method: lists (head, next), or bodies sorted by cell (offsets, bodies).
struct Arrays {
  bool is_sorted, is_hashed;
  const std::vector<int32_t>&cells, &bodies;
  std::vector<size_t> shown{};  ///< entries of `cells`, ascending

  size_t entries() const { return cells.size() - (is_sorted && !cells.empty()); }
  const char* name_of_cells() const { return is_sorted ? "offsets" : "head"; }
  const char* entry_name() const { return is_hashed ? "slots of the table" : "cells"; }
  int rows_of_bodies() const { return is_hashed ? 2 : 1; }
  const char* name_of_bodies() const { return is_sorted ? "bodies" : "next"; }

  /// Visits the bodies of one cell or bucket, in the order of memory.
  template <class Visit>
  void for_each_body(size_t entry, Visit&& visit) const {
    if (is_sorted) {
      for (int32_t slot = cells[entry]; slot < cells[entry + 1]; ++slot) visit(bodies[static_cast<size_t>(slot)]);
    } else {
      for (int32_t body = cells[entry]; body >= 0; body = bodies[static_cast<size_t>(body)]) visit(body);
    }
  }
};

/// All entries of the array of cells, or of a long one those that hold bodies.
std::vector<size_t> shown_entries(const Arrays& arrays) {
  std::vector<size_t> shown;
  const bool is_long = arrays.entries() > kMaxBoxes;
  for (size_t k = 0; k < (is_long ? arrays.entries() : arrays.cells.size()); ++k) {
    const bool is_empty = arrays.is_sorted ? is_long && arrays.cells[k] == arrays.cells[k + 1] : arrays.cells[k] < 0;
    if (!is_long || !is_empty) shown.push_back(k);
  }
  return shown;
}

Arrays arrays_of(const GridInspection& grid) {
  Arrays arrays = grid.arrays
                      ? Arrays{grid.arrays->is_sorted, grid.arrays->is_hashed, grid.arrays->cells, grid.arrays->bodies}
                      : Arrays{false, false, grid.head, grid.next};
  arrays.shown = shown_entries(arrays);
  return arrays;
}

/// The cells of the bodies, in the order of the array of bodies.
std::vector<int32_t> keys_of(const Arrays& arrays, const GridInspection& grid, const BodySnapshot& bodies) {
  std::vector<int32_t> keys;
  for (size_t k = 0; k < arrays.bodies.size(); ++k) {
    const int64_t body = arrays.is_sorted ? arrays.bodies[k] : static_cast<int64_t>(k);
    keys.push_back(static_cast<int32_t>(index_of(grid, cell_of(grid, bodies, body))));
  }
  return keys;
}

/// Draws an array, or of a longer one the entries `shown`.
void draw_array(const char* name, const std::vector<int32_t>& values, const std::vector<size_t>& shown,
                const Boxes& boxes, const Vec3& color, const PageView* page, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  sheet.text({kListMargin * u, boxes.top + boxes.height / 2}, kLeft, painter.ink(), name, TextSize::small);
  for (size_t k = 0; k < shown.size(); ++k) {
    const int32_t value = values[shown[k]];
    const Vec2 low(boxes.left + static_cast<float>(k) * boxes.width, boxes.top);
    const Vec2 high = low + Vec2(boxes.width, boxes.height);
    const bool is_empty = value < 0;
    if (!is_empty) sheet.box(low, high, to_rgba(color, 0.3f));
    sheet.frame(low, high, to_rgba(color), 2 * u);
    if (boxes.number > 0) {
      sheet.text(boxes.over_number(k) + Vec2(0, boxes.number / 2), kCentre, painter.ink(0.65f),
                 std::to_string(shown[k]), TextSize::small);
    }
    const std::string text = value == lecture::kUnset ? "?" : is_empty ? "–1" : std::to_string(value);
    sheet.text((low + high) / 2.0f, kCentre, painter.ink(is_empty ? 0.6f : 1), text, TextSize::small);
    if (page) mark_touched(*page, name, static_cast<int64_t>(shown[k]), low, high, painter);
  }
}

/// An arc below the row; a longer arc is deeper.
void draw_link(const Boxes& next, size_t from, size_t to, Rgba color, Painter& painter) {
  const float u = painter.sheet.unit();
  const Vec2 a = next.under(from), b = next.under(to);
  const float far = std::min(1.0f, std::abs(b.x - a.x) / (12 * next.width));
  const float depth = (0.7f + 1.2f * far) * kArcs * u;  // of the control point: the arc goes half as deep
  painter.sheet.curved_arrow(a, {(a.x + b.x) / 2, a.y + depth}, b + Vec2(0, 2 * u), color, 3 * u);
}

/// The arrays in the picture; `lowest` is the last row of those of the bodies.
struct Rows {
  const Boxes &cells, &bodies, &lowest;
};

/// Along the list of one cell, in box `box`: head → body → next body → …
void draw_list(const Arrays& arrays, size_t box, const Rows& rows, Rgba color, Painter& painter) {
  const int32_t first = arrays.cells[arrays.shown[box]];
  if (first < 0) return;
  auto body = static_cast<size_t>(first);
  painter.sheet.arrow(rows.cells.under(box), rows.bodies.over_number(body), color, 3 * painter.sheet.unit());
  while (arrays.bodies[body] >= 0) {
    const auto following = static_cast<size_t>(arrays.bodies[body]);
    draw_link(rows.lowest, body, following, color, painter);
    body = following;
  }
}

/// The range of one cell: an arrow from its offset to the first slot, and a brace below all of its slots.
void draw_range(const Arrays& arrays, size_t box, const Rows& rows, Rgba color, Painter& painter) {
  const size_t cell = arrays.shown[box];
  const auto first = static_cast<size_t>(arrays.cells[cell]), end = static_cast<size_t>(arrays.cells[cell + 1]);
  if (first == end) return;
  Sheet& sheet = painter.sheet;
  const Boxes& lowest = rows.lowest;
  const float u = sheet.unit(), inset = 0.15f * lowest.width;
  sheet.arrow(rows.cells.under(box), rows.bodies.over_number(first), color, 3 * u);
  const Vec2 left = lowest.under(first) + Vec2(inset - lowest.width / 2, 6 * u),
             right = lowest.under(end - 1) + Vec2(lowest.width / 2 - inset, 6 * u), down(0, 12 * u);
  sheet.line(left, left + down, color, 3 * u);
  sheet.line(left + down, right + down, color, 3 * u);
  sheet.line(right + down, right, color, 3 * u);
}

/// [1/1080 of the picture's height]
float strip_height(const Arrays& arrays, float text_scale) {
  const float line = line_height(TextSize::small, text_scale), box = line + 2 * kPadding;
  return 2 * line + static_cast<float>(1 + arrays.rows_of_bodies()) * box + kListGap + kArcs + kListMargin;
}

bool fits(const Arrays& arrays) { return arrays.shown.size() <= kMaxBoxes + 1 && arrays.bodies.size() <= kMaxBoxes; }

/// Returns false if the boxes would be too narrow for their numbers.
bool draw_arrays(const Arrays& arrays, const std::vector<int32_t>& keys, int64_t selected, const PageView* page,
                 Painter& painter) {
  if (!fits(arrays)) return false;
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  const auto extent_of = [&](const std::string& text) { return sheet.size_of(text, TextSize::small); };
  const float left =
      (kListMargin + 12) * u + std::max(extent_of(arrays.name_of_cells()).x, extent_of(arrays.name_of_bodies()).x);
  const auto count = static_cast<float>(std::max(arrays.shown.size(), arrays.bodies.size()));
  const float line = extent_of("0").y;
  float narrowest = extent_of("–1").x + 4 * u;
  if (!arrays.shown.empty()) narrowest = std::max(narrowest, extent_of(std::to_string(arrays.shown.back())).x + 4 * u);
  const auto width_up_to = [&](float right) { return std::min(kWidest * u, (right - left - kListMargin * u) / count); };
  float width = width_up_to(painter.note_left);  // beside code, if there is room
  if (width < narrowest) width = width_up_to(static_cast<float>(sheet.width()));
  if (width < narrowest) return false;

  const float top = painter.take_strip(strip_height(arrays, sheet.text_scale()) * u), height = line + 2 * kPadding * u;
  const Boxes cells{left, width, top + kListMargin * u / 2 + line, height, line};
  const Boxes bodies{left, width, cells.top + height + kListGap * u + line, height, line};
  std::vector<size_t> all(arrays.bodies.size());
  std::iota(all.begin(), all.end(), size_t{0});
  draw_array(arrays.name_of_cells(), arrays.cells, arrays.shown, cells, painter.theme.grid, page, painter);
  draw_array(arrays.name_of_bodies(), arrays.bodies, all, bodies, painter.theme.body, page, painter);
  Boxes lowest = bodies;
  if (arrays.is_hashed) {
    lowest.top += height;
    lowest.number = 0;
    draw_array("cell", keys, all, lowest, painter.theme.grid, nullptr, painter);
  }
  const size_t boxes = std::min(arrays.shown.size(), arrays.entries());
  for (size_t box = 0; box < boxes; ++box) {
    bool is_selected = false;
    arrays.for_each_body(arrays.shown[box], [&](int32_t body) { is_selected |= body == selected; });
    const Rgba color = is_selected ? to_rgba(painter.theme.selected) : painter.ink(selected < 0 ? 0.75f : 0.55f);
    (arrays.is_sorted ? draw_range : draw_list)(arrays, box, {cells, bodies, lowest}, color, painter);
  }
  if (boxes < arrays.entries()) {
    painter.note(
        phrase("Lists: {} of {} {}, those with spheres", boxes, arrays.entries(), translated(arrays.entry_name())));
  }
  return true;
}

/// Bars in the lower right corner: the length under each, the number of cells above.
void draw_histogram(const std::vector<GridInspection>& grids, Painter& painter) {
  constexpr float kBar = 62, kHigh = 190;
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), line = sheet.size_of("0", TextSize::small).y;
  std::vector<int> counts(kMaxLength + 1, 0);
  for (const GridInspection& grid : grids) {
    const std::vector<int> own = count_lengths(grid, kMaxLength);
    for (size_t k = 0; k < counts.size(); ++k) counts[k] += own[k];
  }
  const bool is_cut = counts.back() > 0;
  while (counts.size() > 1 && counts.back() == 0) counts.pop_back();
  const auto most = static_cast<float>(*std::max_element(counts.begin(), counts.end()));
  const Arrays arrays = arrays_of(grids[0]);
  const std::string title =
      (grids.size() > 1 ? phrase("{} grids: ", grids.size()) : std::string()) + translated(arrays.entry_name());
  const std::string subtitle = translated(arrays.is_sorted ? "by length of their range" : "by length of their list");
  float bar = kBar * u;
  for (const int count : counts) bar = std::max(bar, sheet.size_of(grouped(count), TextSize::small).x + 10 * u);
  const float width = std::max(bar * static_cast<float>(counts.size()), sheet.size_of(subtitle, TextSize::small).x);
  const Vec2 high(static_cast<float>(sheet.width()) - kListMargin * u,
                  static_cast<float>(sheet.height()) - painter.taken - kListMargin * u);
  const Vec2 low = high - Vec2(width, kHigh * u + 5 * line);
  const float ground = high.y - line;
  sheet.box(low - Vec2(kListMargin * u), high + Vec2(kListMargin * u), painter.ground());
  sheet.text({high.x, low.y}, kUpperRight, painter.ink(), title, TextSize::small);
  sheet.text({high.x, low.y + line}, kUpperRight, painter.ink(), subtitle, TextSize::small);
  for (size_t k = 0; k < counts.size(); ++k) {
    const float middle = high.x - (static_cast<float>(counts.size() - k) - 0.5f) * bar;
    const float top = ground - kHigh * u * static_cast<float>(counts[k]) / most;
    const Vec3& color = k == 0 ? painter.theme.idle : painter.theme.grid;
    sheet.box({middle - 0.36f * bar, top}, {middle + 0.36f * bar, ground}, to_rgba(color));
    sheet.text({middle, top}, kBottom, painter.ink(), grouped(counts[k]), TextSize::small);
    const bool is_rest = is_cut && k + 1 == counts.size();
    sheet.text({middle, ground}, kTop, painter.ink(0.8f), (is_rest ? "≥" : "") + std::to_string(k), TextSize::small);
  }
  sheet.line({high.x - bar * static_cast<float>(counts.size()), ground}, {high.x, ground}, painter.ink(0.8f), 2 * u);
}

}  // namespace

std::vector<int> count_lengths(const GridInspection& grid, size_t max) {
  std::vector<int> result(max + 1, 0);
  const Arrays arrays = arrays_of(grid);
  for (size_t entry = 0; entry < arrays.entries(); ++entry) {
    size_t count = 0;
    arrays.for_each_body(entry, [&](int32_t) { ++count; });
    ++result[std::min(count, max)];
  }
  return result;
}

float lists_room(const Inspection& inspection, float text_scale) {
  if (inspection.grids.size() != 1) return 0;
  const Arrays arrays = arrays_of(inspection.grids[0]);
  return fits(arrays) ? (strip_height(arrays, text_scale) + kListMargin) / 1080 : 0.0f;
}

void draw_lists(const FrameView& view, Painter& painter) {
  const std::vector<GridInspection>& grids = view.inspection.grids;
  if (grids.empty()) return;
  const Arrays arrays = arrays_of(grids[0]);
  if (arrays.entries() == 0) {
    painter.note("Lists: this broad phase has too many cells to show; enlarge them");
    return;
  }
  std::vector<int32_t> keys;
  if (arrays.is_hashed) keys = keys_of(arrays, grids[0], view.inspection.bodies);
  const bool is_drawn = grids.size() == 1 && draw_arrays(arrays, keys, view.selected, view.page, painter);
  if (!is_drawn) draw_histogram(grids, painter);
}

}  // namespace ballpit
