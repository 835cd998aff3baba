// SPDX-License-Identifier: MIT
#include "render/overlays/lists.h"

#include <algorithm>

#include "render/overlays/grid.h"
#include "render/painter.h"

namespace ballpit {

namespace {

constexpr size_t kMostBoxes = 32;
constexpr size_t kMostLength = 10;
// In 1/1080 of the picture's height.
constexpr float kMargin = 16, kBoxHeight = 40, kGap = 84, kArcs = 58, kWidest = 72;

/// One array: numbered boxes beside its name.
struct Boxes {
  float left, width, top, height, number;  // [pixel]; `number`: height of the line above with the indices

  float middle(size_t k) const { return left + (static_cast<float>(k) + 0.5f) * width; }
  Vec2 over_number(size_t k) const { return {middle(k), top - number}; }
  Vec2 under(size_t k) const { return {middle(k), top + height}; }
};

void draw_array(const char* name, const std::vector<int32_t>& values, const Boxes& boxes, const Vec3& color,
                Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  sheet.text({kMargin * u, boxes.top + boxes.height / 2}, kLeft, painter.ink(), name);
  for (size_t k = 0; k < values.size(); ++k) {
    const Vec2 low(boxes.left + static_cast<float>(k) * boxes.width, boxes.top);
    const Vec2 high = low + Vec2(boxes.width, boxes.height);
    const bool is_empty = values[k] < 0;
    if (!is_empty) sheet.box(low, high, to_rgba(color, 0.3f));
    sheet.frame(low, high, to_rgba(color), 2 * u);
    sheet.text(boxes.over_number(k) + Vec2(0, boxes.number / 2), kCentre, painter.ink(0.65f), std::to_string(k),
               TextSize::small);
    sheet.text((low + high) / 2.0f, kCentre, painter.ink(is_empty ? 0.55f : 1),
               is_empty ? "–1" : std::to_string(values[k]), TextSize::small);
  }
}

/// An arc below the row, the deeper the farther it goes.
void draw_link(const Boxes& next, size_t from, size_t to, Rgba color, Painter& painter) {
  const float u = painter.sheet.unit();
  const Vec2 a = next.under(from), b = next.under(to);
  const float far = std::min(1.0f, std::abs(b.x - a.x) / (12 * next.width));
  const float depth = (0.7f + 1.2f * far) * kArcs * u;  // of the control point: the arc goes half as deep
  painter.sheet.curved_arrow(a, {(a.x + b.x) / 2, a.y + depth}, b + Vec2(0, 2 * u), color, 3 * u);
}

/// Along the list of one cell: head → body → next body → …
void draw_list(const GridInspection& grid, size_t cell, const Boxes& head, const Boxes& next, Rgba color,
               Painter& painter) {
  if (grid.head[cell] < 0) return;
  auto body = static_cast<size_t>(grid.head[cell]);
  painter.sheet.arrow(head.under(cell), next.over_number(body), color, 3 * painter.sheet.unit());
  while (grid.next[body] >= 0) {
    const auto following = static_cast<size_t>(grid.next[body]);
    draw_link(next, body, following, color, painter);
    body = following;
  }
}

bool holds(const GridInspection& grid, size_t cell, int64_t wanted) {
  for (int32_t body = grid.head[cell]; body >= 0; body = grid.next[static_cast<size_t>(body)]) {
    if (body == wanted) return true;
  }
  return false;
}

bool fits(const GridInspection& grid) { return grid.head.size() <= kMostBoxes && grid.next.size() <= kMostBoxes; }

/// False where boxes would be too narrow for their numbers.
bool draw_arrays(const GridInspection& grid, int64_t selected, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), left = kMargin * u + sheet.size_of("head ").x + 8 * u;
  const auto count = static_cast<float>(std::max(grid.head.size(), grid.next.size()));
  const float width = std::min(kWidest * u, (static_cast<float>(sheet.width()) - left - kMargin * u) / count);
  const Vec2 text = sheet.size_of("–1", TextSize::small);
  if (!fits(grid) || width < text.x + 4 * u) return false;

  const float number = text.y + 2 * u, height = std::max(kBoxHeight * u, text.y + 6 * u);
  const Strip strip = painter.take_strip(2 * (number + height) + (kGap + kArcs + kMargin) * u);
  const Boxes head{left, width, strip.top + kMargin * u / 2 + number, height, number};
  const Boxes next{left, width, head.top + height + kGap * u + number, height, number};
  draw_array("head", grid.head, head, painter.theme.grid, painter);
  draw_array("next", grid.next, next, painter.theme.body, painter);
  for (size_t cell = 0; cell < grid.head.size(); ++cell) {
    const bool is_selected = selected >= 0 && holds(grid, cell, selected);
    draw_list(grid, cell, head, next,
              is_selected ? to_rgba(painter.theme.selected) : painter.ink(selected < 0 ? 0.75f : 0.4f), painter);
  }
  return true;
}

/// Bars in the lower right corner: the length under each, the number of cells above.
void draw_histogram(const GridInspection& grid, Painter& painter) {
  constexpr float kBar = 62, kHigh = 190;
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), line = sheet.size_of("0", TextSize::small).y;
  std::vector<int> counts = count_lengths(grid, kMostLength);
  const bool is_cut = counts.back() > 0;
  while (counts.size() > 1 && counts.back() == 0) counts.pop_back();
  const auto most = static_cast<float>(*std::max_element(counts.begin(), counts.end()));

  const std::string title = "cells by the length of their list";
  float bar = kBar * u;
  for (const int count : counts) bar = std::max(bar, sheet.size_of(grouped(count), TextSize::small).x + 10 * u);
  const float width = std::max(bar * static_cast<float>(counts.size()), sheet.size_of(title, TextSize::small).x);
  const Vec2 high(static_cast<float>(sheet.width()) - kMargin * u,
                  static_cast<float>(sheet.height()) - painter.taken - kMargin * u);
  const Vec2 low = high - Vec2(width, kHigh * u + 4 * line);
  const float ground = high.y - line;
  sheet.box(low - Vec2(kMargin * u), high + Vec2(kMargin * u), painter.ground());
  sheet.text({high.x, low.y}, kUpperRight, painter.ink(), title, TextSize::small);
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

std::vector<int> count_lengths(const GridInspection& grid, size_t most) {
  std::vector<int> result(most + 1, 0);
  for (const int count : count_per_cell(grid)) ++result[std::min(static_cast<size_t>(count), most)];
  return result;
}

float lists_room(const Inspection& inspection) {
  return !inspection.grids.empty() && fits(inspection.grids[0]) ? 0.29f : 0.0f;
}

void ListsOverlay::draw(const FrameView& view, Painter& painter, Layer layer) {
  if (layer != Layer::over || view.inspection.grids.empty() || view.inspection.grids[0].head.empty()) return;
  const GridInspection& grid = view.inspection.grids[0];
  if (!draw_arrays(grid, view.selected, painter)) draw_histogram(grid, painter);
}

}  // namespace ballpit
