// SPDX-License-Identifier: MIT
#include "render/notes_room.h"

#include <array>

#include "render/coloring.h"
#include "render/overlays/overlay.h"
#include "render/page_view.h"
#include "render/sheet.h"

namespace ballpit {

namespace {

// [1/1080 of the picture's height], text at scale 1
constexpr float kNotesMargin = 16, kLineGap = 4;
constexpr float kLegend = 680;        // width of the widest legend: five ranges, or the longest name
constexpr float kPlanarNotes = 0.2f;  // [of the picture's width] of notes beside a planar domain
constexpr float kLeastNotes = 0.4f;   // [of the same] beside a legend; narrower ones go below it

/// Lines of all notes that these overlays may write, in a picture that is wide enough for one line of each other one.
int count_lines(const FrameView& view, float text_scale) {
  constexpr float kWide = 1.2f;  // text that the densest cells' note does not fit beside a legend
  int lines = 0;
  if (view.shows("grid") && draws_densest(view)) lines = text_scale > kWide ? 2 : 1;
  for (const OverlayEntry& entry : overlay_table()) {
    if (!view.shows(entry.name)) continue;
    const bool is_lacking = !entry.lack(view.inspection).empty();
    const bool is_compared = view.page && !view.page->figures.empty();  // then it says nothing
    lines += is_lacking ? (is_compared ? 0 : 1) : entry.notes;
  }
  return lines;
}

}  // namespace

bool overlaps_domain(const DomainBox& domain, const Camera& camera, Vec2 low, Vec2 high, Vec2 size) {
  const auto [min, max] = domain.framed.value_or(FramedBox{domain.min, domain.max});
  const Mat4 clip = camera.projection() * camera.view();
  std::array<Vec2, 8> corners;
  for (int k = 0; k < 8; ++k) {
    const Vec4 at = clip * Vec4(corner_of(min, max, k), 1);
    if (at.w <= 0) return true;  // the eye is within the domain
    corners[static_cast<size_t>(k)] = Vec2(1 + at.x / at.w, 1 - at.y / at.w) / 2.0f * size;
  }
  // Two convex shapes are apart if a line along an edge of one of them separates them.
  const std::array<Vec2, 4> rectangle{low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)};
  const auto separates = [&](Vec2 normal) {
    float near = INFINITY, far = -INFINITY, least = INFINITY, most = -INFINITY;
    for (const Vec2& corner : corners) {
      near = std::min(near, dot(normal, corner));
      far = std::max(far, dot(normal, corner));
    }
    for (const Vec2& corner : rectangle) {
      least = std::min(least, dot(normal, corner));
      most = std::max(most, dot(normal, corner));
    }
    return most <= near || far <= least;
  };
  if (separates({1, 0}) || separates({0, 1})) return false;
  for (const Vec2& a : corners) {
    for (const Vec2& b : corners) {
      if (a != b && separates({a.y - b.y, b.x - a.x})) return false;
    }
  }
  return true;
}

NotesRoom notes_room(const FrameView& view, float text_scale, float above) {
  const Vec2 size(1080 * view.camera.aspect, 1080);
  const float line = line_height(TextSize::small, text_scale), top = above * size.y;
  const bool has_legend = view.coloring != coloring_table().front().name;
  const int lines = count_lines(view, text_scale) * (view.camera.aspect < 1 ? 2 : 1);
  const float legend = has_legend ? std::min(size.x, kLegend * text_scale) : 0;
  const float legend_height = has_legend ? kNotesMargin + 2 * line + kLineGap : 0;
  const float notes_height = lines > 0 ? kNotesMargin + static_cast<float>(lines) * (line + kLineGap) : 0;
  const Vec2 beside(kPlanarNotes * size.x, size.y / 2);  // notes continue in more lines
  const auto is_free = [&](Vec2 low, Vec2 high) { return !overlaps_domain(view.domain, view.camera, low, high, size); };
  const bool is_still = view.domain.is_planar();  // what is free in space depends on the direction of the view
  const bool fit_notes = lines == 0 || (is_still && is_free({0, top}, {beside.x + kNotesMargin, top + beside.y}));
  const bool fits_legend = !has_legend || (is_still && is_free({size.x - legend, top}, {size.x, top + legend_height}));
  if (fit_notes && fits_legend) return {0, kPlanarNotes, 0};
  const float width = size.x - legend;
  if (lines == 0 || width >= kLeastNotes * size.x)
    return {std::max(notes_height, legend_height) / size.y, (width - 2 * kNotesMargin) / size.x, 0};
  return {(notes_height + legend_height) / size.y, 1 - 2 * kNotesMargin / size.x, legend_height / size.y};
}

}  // namespace ballpit
