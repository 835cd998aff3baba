// SPDX-License-Identifier: MIT
#include "render/coloring.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/language.h"
#include "render/painter.h"

namespace ballpit {

namespace {

// [1/1080 of the picture's height] kStep: width of a colour of the scale
constexpr float kLegendMargin = 24, kAbove = 16, kLegendPad = 8, kStep = 18;

/// No marks, since the method has no such quantity.
Colored nothing_of(const Inspection& inspection, const char* lacking) {
  return {std::vector<Mark>(static_cast<size_t>(inspection.bodies.count), Mark::none), "", "", {}, lacking};
}

Colored by_contact(const Inspection& inspection) {
  return {contact_marks(inspection.bodies.count, inspection.contacts)};
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
  std::vector<int> touching(static_cast<size_t>(inspection.bodies.count), 0);
  for (const Pair& pair : inspection.contacts) {
    for (const int body : {pair.i, pair.j}) touching[static_cast<size_t>(body)] += 1;
  }
  return on_whole_numbers(touching, 0);
}

/// By value(position in the list of the cell, length of the list), whose smallest possible value is `first`.
template <class Value>
Colored by_listed(const Inspection& inspection, int first, Value&& value) {
  if (inspection.grids.empty()) return nothing_of(inspection, "this method has no cells");
  std::vector<int> values(static_cast<size_t>(inspection.bodies.count), first);
  for (const GridInspection& grid : inspection.grids) {
    for (const int32_t head : grid.head) {
      int count = 0, k = 0;
      for (int32_t b = head; b >= 0; b = grid.next[static_cast<size_t>(b)]) ++count;
      for (int32_t b = head; b >= 0; b = grid.next[static_cast<size_t>(b)], ++k) {
        values[static_cast<size_t>(b)] = value(grid.is_sorted() ? count - 1 - k : k, count);
      }
    }
  }
  return on_whole_numbers(values, first);
}

Colored by_cell(const Inspection& inspection) {
  return by_listed(inspection, 1, [](int, int count) { return count; });
}

Colored by_list(const Inspection& inspection) {
  return by_listed(inspection, 0, [](int position, int) { return position; });
}

Colored by_work(const Inspection& inspection) {
  if (inspection.work.empty()) return nothing_of(inspection, "this method has no thread for each sphere");
  std::vector<int> work(static_cast<size_t>(inspection.bodies.count), 0);
  for (size_t t = 0; t < inspection.work.size(); ++t) {
    const int32_t body = inspection.worker[t];
    if (body >= 0) work[static_cast<size_t>(body)] += static_cast<int>(inspection.work[t]);
  }
  return on_whole_numbers(work, 0);
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
  constexpr float kLight = 1.2f;                             // the lit side of a sphere is paler than its colour
  const bool is_light = luminance(theme.background) > 0.5f;  // on a dark ground, pale colours are visible
  return mark >= 2 && is_light && least < kLight * kMinContrast ? 3.0f : 0.0f;
}

void draw_legend(const ColoringEntry& coloring, const Colored& colored, Painter& painter) {
  if (!colored.has_scale() && colored.lacking.empty()) return;
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), line = sheet.size_of("0", TextSize::small).y, pad = kLegendPad * u;
  const float right = static_cast<float>(sheet.width()) - kLegendMargin * u, room = right - kLegendMargin * u;
  float y = kAbove * u + (painter.note_left > 0 ? 0 : painter.noted);
  const auto text = [&](float x, const std::string& words, float scale = 1) {
    sheet.text({x, y}, kUpperRight, painter.ink(), words, TextSize::small, scale);
    painter.cover({x - scale * sheet.size_of(words, TextSize::small).x, y}, {x, y + line});
  };
  const auto in_line = [&](const std::string& words) {
    text(right, words, std::min(1.0f, room / std::max(1.0f, sheet.size_of(words, TextSize::small).x)));
    y += line;
  };
  in_line(translated(coloring.label));
  if (!colored.lacking.empty()) return in_line(translated(colored.lacking));

  const bool has_numbers = !colored.boxes.empty();
  std::vector<LegendBox> boxes = colored.boxes;
  for (int k = 0; !has_numbers && k < kScaleColors; ++k) boxes.push_back({scale_mark(k), ""});
  const auto width_of = [&](const std::string& words, float least) {
    return words.empty() ? least : sheet.size_of(words, TextSize::small).x + 2 * pad;
  };
  float all = width_of(colored.low, 0) + width_of(colored.high, 0);
  for (const LegendBox& box : boxes) all += width_of(box.text, kStep * u);
  const float scale = std::min(1.0f, room / all);
  text(right, colored.high, scale);
  const float end = right - scale * width_of(colored.high, 0);
  float x = end;
  for (size_t k = boxes.size(); k-- > 0;) {
    const Vec3 color = color_of(painter.theme, static_cast<int>(boxes[k].mark));
    const float width = scale * width_of(boxes[k].text, kStep * u);
    sheet.box({x - width, y}, {x, y + line}, to_rgba(color));
    sheet.text({x - width / 2, y + line / 2}, kCentre, to_rgba(text_on(color)), boxes[k].text, TextSize::small, scale);
    x -= width;
  }
  sheet.frame({x, y}, {end, y + line}, painter.ink(), 1.5f * u);  // around colours that are as pale as the ground
  painter.cover({x, y}, {end, y + line});
  text(x - scale * pad, colored.low, scale);
}

}  // namespace ballpit
