// SPDX-License-Identifier: MIT
#include "render/page_view.h"

#include <algorithm>
#include <cmath>

#include "render/painter.h"

namespace ballpit {

namespace {

// [1/1080 of the picture's height]
constexpr float kMargin = 24, kPad = 10;
constexpr float kSign = 44;            // of a method's sign with the space after it
constexpr float kSlides = 260;         // of "Slides 2–4" with its margins, in a lecture
constexpr float kCodeWidth = 0.47f;    // of the picture's width
constexpr float kCodeSpacing = 1.12f;  // from one line of code to the next [its height]
constexpr float kLegends = 3;          // lines below the code: what the step did, and legends
constexpr float kLeastCode = 0.65f;    // [its full size] even where the legend then reaches beside the arrays
constexpr float kMeanLetter = 0.40f;   // of a sentence [height of a line]

/// As large as it fits; the legend follows below.
void draw_code(const PageView& page, float top, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), width = kCodeWidth * static_cast<float>(sheet.width());
  float widest = 1;
  for (const std::string& text : page.code) widest = std::max(widest, sheet.size_of(text, TextSize::code).x);
  const float pitch = sheet.size_of("0", TextSize::code).y * kCodeSpacing, count = static_cast<float>(page.code.size());
  const float free = (1 - page.below) * static_cast<float>(sheet.height()) - top -
                     kLegends * sheet.size_of("0", TextSize::small).y - 4 * kPad * u;
  const float scale =
      std::min({1.0f, (width - (kMargin + 2 * kPad) * u) / widest, std::max(kLeastCode, free / (count * pitch))});
  const float line = scale * pitch, left = static_cast<float>(sheet.width()) - width;
  const Vec2 corner(left, top);
  const float height = line * count + 2 * kPad * u;
  sheet.box(corner, {left + width - kMargin * u, top + height}, painter.ground(), 6 * u);
  for (size_t k = 0; k < page.code.size(); ++k) {
    const float y = top + kPad * u + static_cast<float>(k) * line;
    const bool is_current = static_cast<int>(k) == page.line;
    if (is_current) {
      sheet.box({left, y}, {left + width - kMargin * u, y + line}, to_rgba(painter.theme.selected, 0.35f));
    }
    sheet.text({left + kPad * u, y + line / 2}, kLeft, painter.ink(is_current ? 1 : 0.75f), page.code[k],
               TextSize::code, scale);
  }
  float y = top + height + kPad * u;
  for (const std::string& text : wrap_text(sheet, page.step, width - 2 * kMargin * u, TextSize::small)) {
    sheet.text({left + kPad * u, y}, kUpperLeft, painter.ink(), text, TextSize::small);
    y += sheet.size_of("0", TextSize::small).y;
  }
  painter.note_left = left - kPad * u / 2;
  painter.note_width = width - 2 * kMargin * u;
  painter.noted = y - kPad * u;
}

/// The sign of a method, from `at` to the right, in its colour of charts.
void draw_sign(MethodSign sign, Vec2 at, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float r = 0.3f * kSign * painter.sheet.unit();
  const Theme& theme = painter.theme;
  const Vec2 middle = at + Vec2(r, 0);
  switch (sign) {
    case MethodSign::none:
      break;
    case MethodSign::ring:
      sheet.ring(middle, r, painter.ink(), 0.4f * r);
      break;
    case MethodSign::triangle:
      sheet.triangle(middle - Vec2(0, 1.1f * r), middle + Vec2(1.1f * r, 0.9f * r), middle + Vec2(-1.1f * r, 0.9f * r),
                     to_rgba(theme.begin));
      break;
    case MethodSign::square:
      sheet.box(middle - Vec2(r), middle + Vec2(r), to_rgba(theme.grid));
      break;
    case MethodSign::diamond:
      for (const float side : {-1.3f * r, 1.3f * r}) {
        sheet.triangle(middle - Vec2(1.1f * r, 0), middle + Vec2(1.1f * r, 0), middle + Vec2(0, side),
                       to_rgba(theme.missed));
      }
      break;
  }
}

/// One below the other at the lower edge.
void draw_figures(const std::vector<std::string>& figures, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), line = sheet.size_of("0").y, room = static_cast<float>(sheet.width()) - 2 * kMargin * u;
  float y = painter.take_strip(line * static_cast<float>(figures.size()) + 2 * kPad * u) + kPad * u + line / 2;
  for (const std::string& text : figures) {
    const float scale = std::min(1.0f, room / std::max(sheet.size_of(text).x, 1.0f));
    sheet.text({kMargin * u, y}, kLeft, painter.ink(), text, TextSize::normal, scale);
    y += line;
  }
}

}  // namespace

Room room_of(const PageView& page, float text_scale, float aspect, float share) {
  Room room;
  const float height = 1080 * share;
  room.above = (line_height(TextSize::title, text_scale) + kPad) / height;
  const float line = line_height(TextSize::normal, text_scale);
  if (!page.figures.empty()) {
    room.below = (line * static_cast<float>(page.figures.size()) + 2 * kPad) / height;
    return room;
  }
  const float width = height * aspect - 2 * kMargin - (page.slides.empty() ? 0 : kSlides);
  const auto begins_letter = [](char byte) { return (byte & 0xC0) != 0x80; };  // in UTF-8
  const float wanted = kMeanLetter * line * static_cast<float>(std::ranges::count_if(page.caption, begins_letter));
  room.below = (line * std::ceil(std::max(wanted / width, 1.0f)) + 2 * kPad) / height;
  if (!page.code.empty()) room.right = kCodeWidth;
  return room;
}

void mark_touched(const PageView& page, std::string_view array, int64_t index, Vec2 low, Vec2 high, Painter& painter) {
  if (page.touched_array != array || page.touched_index != index) return;
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  const Rgba color = to_rgba(painter.theme.selected);
  sheet.frame(low, high, color, 5 * u);
  if (page.old_text.empty()) return;
  const Vec2 size = sheet.size_of(page.old_text, TextSize::small), at(high.x + 4 * u, low.y - 0.3f * size.y);
  sheet.box(at - Vec2(2 * u, 0), at + size + Vec2(2 * u, 0), painter.ground());
  sheet.text(at, kUpperLeft, painter.ink(0.75f), page.old_text, TextSize::small);
  sheet.line(at + Vec2(-3 * u, 0.55f * size.y), at + Vec2(size.x + 3 * u, 0.55f * size.y), color, 3 * u);
}

void draw_page(const PageView& page, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), width = static_cast<float>(sheet.width());
  const float title = page.title.empty() ? 0 : sheet.size_of("0", TextSize::title).y + kPad * u;
  sheet.box({0, 0}, {width, title}, to_rgba(painter.theme.background));  // spheres and edges may rise this high
  const float left = (page.sign == MethodSign::none ? kMargin : kMargin + kSign) * u;
  const float room = width - left - kMargin * u, wanted = sheet.size_of(page.title, TextSize::title).x;
  const bool fits = wanted <= room;
  draw_sign(page.sign, {kMargin * u, title / 2}, painter);
  sheet.text({left, kPad * u / 2}, kUpperLeft, painter.ink(), page.title, fits ? TextSize::title : TextSize::small);
  if (page.has_views) {
    sheet.box({0, title}, {width, static_cast<float>(sheet.height())}, painter.ink(0.4f));
    return;
  }
  painter.noted = title;
  painter.note_left = kPad * u;
  if (!page.figures.empty()) return draw_figures(page.figures, painter);
  const float slides = page.slides.empty() ? 0 : sheet.size_of(page.slides, TextSize::small).x + 2 * kMargin * u;
  const std::vector<std::string> lines =
      wrap_text(sheet, page.caption, width - 2 * kMargin * u - slides, TextSize::normal);
  const float line = sheet.size_of("0").y;
  float y = painter.take_strip(line * static_cast<float>(lines.size()) + 2 * kPad * u) + kPad * u;
  for (const std::string& text : lines) {
    sheet.text({kMargin * u, y}, kUpperLeft, painter.ink(), text);
    y += line;
  }
  const Vec2 corner(width - kMargin * u, static_cast<float>(sheet.height()) - kPad * u);
  sheet.text(corner, {1, 1}, painter.ink(0.75f), page.slides, TextSize::small);
  if (!page.code.empty()) draw_code(page, title + kPad * u, painter);
}

}  // namespace ballpit
