// SPDX-License-Identifier: MIT
#include "render/coloring.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/language.h"
#include "render/painter.h"

namespace ballpit {

namespace {

/// Places values on the scale, from the smallest to the largest.
Colored on_scale(const std::vector<float>& values, const char* unit, bool starts_at_zero) {
  Colored result;
  if (values.empty()) return result;
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  const float low = starts_at_zero ? std::min(0.0f, *min) : *min, range = *max - low;
  result.marks.reserve(values.size());
  for (const float value : values) {
    const float part = range > 0 ? (value - low) / range : 0.0f;
    result.marks.push_back(scale_mark(std::clamp(static_cast<int>(part * kScaleColors), 0, kScaleColors - 1)));
  }
  result.low = local_number(fmt::format("{:.3g}{}", low, unit));
  result.high = local_number(fmt::format("{:.3g}{}", *max, unit));
  return result;
}

/// No marks, since the method has no such quantity.
Colored nothing_of(const Inspection& inspection, const char* lacking) {
  return {std::vector<Mark>(static_cast<size_t>(inspection.bodies.count), Mark::none), "", "", lacking};
}

Colored by_contact(const Inspection& inspection) {
  return {contact_marks(inspection.bodies.count, inspection.contacts), "", ""};
}

Colored by_speed(const Inspection& inspection) {
  const BodySnapshot& bodies = inspection.bodies;
  std::vector<float> speed;
  for (int64_t i = 0; i < bodies.count; ++i) speed.push_back(length(bodies.velocity_of(i)));
  return on_scale(speed, " m/s", true);
}

Colored by_size(const Inspection& inspection) {
  std::vector<float> radius;
  for (int64_t i = 0; i < inspection.bodies.count; ++i) radius.push_back(inspection.bodies.radius_of(i));
  return on_scale(radius, " m", false);
}

Colored by_touching(const Inspection& inspection) {
  std::vector<float> touching(static_cast<size_t>(inspection.bodies.count), 0);
  for (const Pair& pair : inspection.contacts) {
    for (const int body : {pair.i, pair.j}) touching[static_cast<size_t>(body)] += 1;
  }
  return on_scale(touching, "", true);
}

/// By value(position in the list of the cell, length of the list).
template <class Value>
Colored by_listed(const Inspection& inspection, Value&& value) {
  if (inspection.grids.empty()) return nothing_of(inspection, "this method has no cells");
  std::vector<float> values(static_cast<size_t>(inspection.bodies.count), 0);
  for (const GridInspection& grid : inspection.grids) {
    for (const int32_t head : grid.head) {
      int count = 0, k = 0;
      for (int32_t b = head; b >= 0; b = grid.next[static_cast<size_t>(b)]) ++count;
      for (int32_t b = head; b >= 0; b = grid.next[static_cast<size_t>(b)], ++k) {
        values[static_cast<size_t>(b)] = static_cast<float>(value(grid.is_sorted() ? count - 1 - k : k, count));
      }
    }
  }
  return on_scale(values, "", true);
}

Colored by_cell(const Inspection& inspection) {
  return by_listed(inspection, [](int, int count) { return count; });
}

Colored by_list(const Inspection& inspection) {
  return by_listed(inspection, [](int position, int) { return position; });
}

Colored by_work(const Inspection& inspection) {
  if (inspection.work.empty()) return nothing_of(inspection, "this method has no thread for each sphere");
  std::vector<float> work(static_cast<size_t>(inspection.bodies.count), 0);
  for (size_t t = 0; t < inspection.work.size(); ++t) {
    const int32_t body = inspection.worker[t];
    if (body >= 0) work[static_cast<size_t>(body)] += static_cast<float>(inspection.work[t]);
  }
  return on_scale(work, "", true);
}

/// cividis at equal distances.
constexpr std::array<unsigned, 9> kCividis{0x00224E, 0x123570, 0x3B496C, 0x575D6D, 0x707173,
                                           0x8A8678, 0xA59C74, 0xC3B369, 0xFEE838};

/// `part` from 0 to 1.
Vec3 cividis(float part) {
  const float at = part * static_cast<float>(kCividis.size() - 1);
  const size_t k = std::min(static_cast<size_t>(at), kCividis.size() - 2);
  return glm::mix(rgb(kCividis[k]), rgb(kCividis[k + 1]), at - static_cast<float>(k));
}

}  // namespace

const std::vector<ColoringEntry>& coloring_table() {
  static const std::vector<ColoringEntry> table = {
      {"contact", "Contact: who touches", by_contact, {.state = false}},
      {"speed", "Speed", by_speed, {}},
      {"size", "Radius", by_size, {}},
      {"contacts", "Number of contacts", by_touching, {}},
      {"cell", "Spheres in the same cell", by_cell, {}},
      {"list", "Place in the cell's list", by_list, {}},
      {"work", "Steps of the sphere's thread", by_work, {.work = true}},
  };
  return table;
}

const ColoringEntry& coloring_named(std::string_view name) { return entry_named(coloring_table(), name, "--color"); }

Vec3 color_of(const Theme& theme, int mark) {
  if (mark == static_cast<int>(Mark::none)) return theme.body;
  if (mark == static_cast<int>(Mark::contact)) return theme.contact;
  // The darkest colours are invisible on a dark ground: below 0.5, their contrast to the floor is less than 3.
  const float step = static_cast<float>(mark - 2) / static_cast<float>(kScaleColors - 1);
  const float darkest = theme.background.r < 0.5f ? 0.5f : 0.0f;
  return cividis(darkest + (1 - darkest) * step);
}

float rim_width(const Theme& theme, int mark) {
  if (mark == static_cast<int>(Mark::contact)) return 6;
  const Vec3 color = color_of(theme, mark);
  const float least = std::min(contrast(color, theme.background), contrast(color, theme.floor));
  constexpr float kLight = 1.2f;  // the lit side of a sphere is paler than its colour
  const bool is_light = luminance(theme.background) > 0.5f;  // on a dark ground, pale colours are visible
  return mark >= 2 && is_light && least < kLight * kMinContrast ? 3.0f : 0.0f;
}

void draw_legend(const ColoringEntry& coloring, const Colored& colored, Painter& painter) {
  if (colored.low.empty() && colored.lacking.empty()) return;
  Sheet& sheet = painter.sheet;
  const float unit = sheet.unit(), width = 18 * unit, height = 26 * unit, margin = 24 * unit;
  const float line = sheet.size_of("0", TextSize::small).y, top = margin + (painter.note_left > 0 ? 0 : painter.noted);
  const Rgba ink = to_rgba(painter.theme.text);
  const Vec2 right(static_cast<float>(sheet.width()) - margin, top);
  sheet.text(right, kUpperRight, ink, translated(coloring.label), TextSize::small);
  if (!colored.lacking.empty()) {
    sheet.text(right + Vec2(0, line), kUpperRight, ink, translated(colored.lacking), TextSize::small);
    return;
  }
  const Vec2 corner = right + Vec2(-kScaleColors * width, line + 4 * unit);
  for (int k = 0; k < kScaleColors; ++k) {
    const Vec2 low = corner + Vec2(static_cast<float>(k) * width, 0);
    sheet.box(low, low + Vec2(width, height), to_rgba(color_of(painter.theme, static_cast<int>(scale_mark(k)))));
  }
  const Vec2 foot = corner + Vec2(0, height + 4 * unit);
  sheet.text(foot, kUpperLeft, ink, colored.low, TextSize::small);
  sheet.text(foot + Vec2(kScaleColors * width, 0), kUpperRight, ink, colored.high, TextSize::small);
}

}  // namespace ballpit
