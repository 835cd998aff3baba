// SPDX-License-Identifier: MIT
// Writes the number of each sphere at its centre, if the sphere is large enough and not hidden. In planar scenes with
// few cells also the number of each cell: always in its lower left corner (slide 8), in front of spheres. On a page of
// a lecture, whose spheres stand still, a number that would be hidden there is in another corner of its cell.
#include <algorithm>
#include <array>

#include "core/phrase.h"
#include "render/body_buffer.h"
#include "render/coloring.h"
#include "render/overlays/overlay.h"
#include "render/page_view.h"

namespace ballpit {

namespace {

constexpr float kMinRadius = 7;       // [pixel] of a sphere
constexpr size_t kMaxSpheres = 3000;  // of more spheres, the nearest get numbers
constexpr size_t kMaxCells = 400;
constexpr float kMostHidden = 0.15f;  // of a cell's number, by the number of a sphere
constexpr float kMostHiddenOnPage = 0.4f;
constexpr float kHeadOfDigits = 0.18f, kFootOfDigits = 0.79f;  // of digits, in their line of text

struct Seen {
  int64_t body;
  Vec2 at;
  float radius, depth;
};

/// Spheres large enough for a number, from near to far.
std::vector<Seen> large_spheres(const FrameView& view, const Projection& projection, const Sheet& sheet) {
  const BodySnapshot& bodies = view.inspection.bodies;
  std::vector<Seen> seen;
  for (int64_t i = 0; i < bodies.count; ++i) {
    const Vec3 centre = bodies.position_of(i);
    if (!projection.sees(centre)) continue;
    const float radius = projection.length_at(centre, bodies.radius_of(i));
    const Vec2 at = projection.at(centre);
    const bool is_outside =
        at.x < 0 || at.y < 0 || at.x > static_cast<float>(sheet.width()) || at.y > static_cast<float>(sheet.height());
    if (radius >= kMinRadius && !is_outside) seen.push_back({i, at, radius, projection.depth(centre)});
  }
  std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.depth < b.depth; });
  if (seen.size() > kMaxSpheres) seen.resize(kMaxSpheres);
  return seen;
}

/// The largest size in which a number fits into its sphere.
std::optional<TextSize> size_within(const std::string& text, float radius, const Sheet& sheet) {
  for (const TextSize size : {TextSize::normal, TextSize::small}) {
    const Vec2 extent = sheet.size_of(text, size);
    if (extent.x <= 1.7f * radius && extent.y <= 2 * radius) return size;
  }
  if (sheet.size_of(text, TextSize::small).x <= 2.2f * radius) return TextSize::small;
  return std::nullopt;
}

struct Area {
  Vec2 low, high;
};

bool meets(const Area& area, const Seen& sphere) {
  return length(glm::clamp(sphere.at, area.low, area.high) - sphere.at) < sphere.radius;
}

/// The part of b that lies under a.
float covered(const Area& b, const Area& a) {
  const Vec2 both = glm::max(glm::min(a.high, b.high) - glm::max(a.low, b.low), Vec2(0)), size = b.high - b.low;
  return both.x * both.y / std::max(size.x * size.y, 1e-6f);
}

bool meets(const Area& a, const Area& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// The number of a sphere.
struct Number {
  Seen sphere;
  Area area;
  std::string text;
  TextSize size;
};

/// From near to far: a sphere gets no number where a nearer sphere or number covers it.
std::vector<Number> place_numbers(const FrameView& view, const std::vector<Seen>& spheres, const Sheet& sheet) {
  std::vector<Number> numbers;
  for (size_t k = 0; k < spheres.size(); ++k) {
    const Seen& sphere = spheres[k];
    const std::string text = std::to_string(sphere.body);
    const std::optional<TextSize> size = size_within(text, sphere.radius, sheet);
    if (!size) continue;
    const Vec2 half = Vec2(0.5f, (kFootOfDigits - kHeadOfDigits) / 2) * sheet.size_of(text, *size);
    const Area area{sphere.at - half, sphere.at + half};
    const auto end = spheres.begin() + static_cast<std::ptrdiff_t>(view.domain.is_planar() ? 0 : k);
    if (std::any_of(spheres.begin(), end, [&](const Seen& nearer) { return meets(area, nearer); })) continue;
    if (std::any_of(numbers.begin(), numbers.end(), [&](const Number& other) { return meets(area, other.area); })) {
      continue;
    }
    numbers.push_back({sphere, area, text, *size});
  }
  return numbers;
}

/// In their spheres' colours. Where lines meet in the centre, with a plate behind.
void draw_numbers(const FrameView& view, const std::vector<Number>& numbers, Painter& painter) {
  const std::vector<Mark> marks =
      painter.marks ? *painter.marks : contact_marks(view.inspection.bodies.count, view.inspection.contacts);
  const bool has_plates = view.shows("pairs") || view.shows("velocity") || view.shows("intervals");
  for (const Number& number : numbers) {
    const Vec3 fill = color_of(painter.theme, static_cast<int>(marks[static_cast<size_t>(number.sphere.body)]));
    if (has_plates) {
      const Vec2 edge(3 * painter.sheet.unit());
      painter.sheet.box(number.area.low - edge, number.area.high + edge, to_rgba(fill, 0.85f), 2 * edge.x);
    }
    painter.sheet.bordered_text(number.sphere.at, kCentre, to_rgba(text_on(fill)), to_rgba(fill), number.text,
                                number.size);
  }
}

/// Where the number of a cell may be.
struct CellNumber {
  Vec2 at;    ///< the upper left corner of its line of text
  Area area;  ///< of its digits
};

/// The number in each corner of its cell, the lower left one first.
std::array<CellNumber, 4> cell_number_places(Vec2 low, Vec2 high, Vec2 extent, Vec2 inset) {
  const float foot = low.y - inset.y - kFootOfDigits * extent.y, head = high.y + inset.y - kHeadOfDigits * extent.y;
  const float left = low.x + inset.x, right = high.x - inset.x - extent.x;
  std::array<CellNumber, 4> places;
  size_t k = 0;
  for (const Vec2& at : {Vec2(left, foot), Vec2(left, head), Vec2(right, foot), Vec2(right, head)}) {
    places[k++] = {at, {at + Vec2(0, kHeadOfDigits * extent.y), at + Vec2(extent.x, kFootOfDigits * extent.y)}};
  }
  return places;
}

/// How much of a cell's number is hidden: by the number of a sphere; spheres below it make it harder to read.
float hidden_part(const Area& area, const std::vector<Number>& numbers) {
  constexpr float kOnSphere = 0.01f;
  float hidden = 0;
  for (const Number& number : numbers) {
    hidden = std::max({hidden, covered(area, number.area), meets(area, number.sphere) ? kOnSphere : 0});
  }
  return hidden;
}

/// Each in a corner of its cell, in the lower left one as on the slide unless the scene stands still and another is
/// easier to read. Returns how many were drawn: none where the number of a sphere hides it.
size_t draw_cell_numbers(const GridInspection& grid, const std::vector<Number>& numbers, const FrameView& view,
                         const Projection& projection, Painter& painter) {
  const bool is_still = view.page && view.page->is_still;
  Sheet& sheet = painter.sheet;
  const float edge = projection.length_at(grid.origin, std::min(grid.edge.x, grid.edge.y));
  const TextSize size = edge > 4.5f * sheet.size_of("0").y ? TextSize::normal : TextSize::small;
  const Vec2 widest = sheet.size_of(std::to_string(grid.head.size() - 1), size), inset = Vec2(6) * sheet.unit();
  if (edge < widest.x + 0.5f * widest.y) return 0;
  const auto columns = static_cast<size_t>(grid.cells.x);
  size_t drawn = 0;
  for (size_t cell = 0; cell < grid.head.size(); ++cell) {
    const IVec3 corner(cell % columns, cell / columns, 0);
    const std::string text = std::to_string(cell);
    const auto places = cell_number_places(projection.at(lattice_point(grid, view.domain, corner)),
                                           projection.at(lattice_point(grid, view.domain, corner + IVec3(1, 1, 0))),
                                           sheet.size_of(text, size), inset);
    const auto hidden = [&](const CellNumber& place) { return hidden_part(place.area, numbers); };
    const CellNumber& place = is_still ? *std::ranges::min_element(places, {}, hidden) : places[0];
    if (hidden(place) > (is_still ? kMostHiddenOnPage : kMostHidden)) continue;
    sheet.bordered_text(place.at, kUpperLeft, to_rgba(painter.theme.cell_text), to_rgba(painter.theme.background), text,
                        size);
    ++drawn;
  }
  return drawn;
}

}  // namespace

void draw_labels(const FrameView& view, Painter& painter) {
  const Projection projection(view.camera, painter.sheet);
  const std::vector<Seen> spheres = large_spheres(view, projection, painter.sheet);
  const std::vector<Number> numbers = place_numbers(view, spheres, painter.sheet);
  const std::vector<GridInspection>& grids = view.inspection.grids;
  if (view.domain.is_planar() && grids.size() == 1 && !grids[0].head.empty()) {
    if (grids[0].head.size() > kMaxCells || draw_cell_numbers(grids[0], numbers, view, projection, painter) == 0) {
      painter.note("Numbers: the cells are too small for theirs");
    }
  }
  draw_numbers(view, numbers, painter);
  const int64_t count = view.inspection.bodies.count;
  if (numbers.empty() && count > 0) {
    painter.note("Numbers: the spheres are too small in the picture; come closer or show fewer");
  } else if (static_cast<int64_t>(numbers.size()) < count) {
    painter.note(phrase("Numbers: {} of {}; the other spheres are hidden or too small",
                        grouped(static_cast<int64_t>(numbers.size())), grouped(count)));
  }
}

}  // namespace ballpit
