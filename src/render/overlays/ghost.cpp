// SPDX-License-Identifier: MIT
// Draws where exact motion has the spheres, how far they are from there, and the first collision that is wrong.
//
//      ╭┈┈╮
//     ( o──┊─○ )     a translucent twin with a dotted outline, and a line to it; none for spheres close to theirs
//      ╰┈┈╯          ◎ a double ring where the first wrong collision was
//
//     ▒▒▒▒▒▒▒▒▒▒▒▒▒▒ the curve of the distance: render/ghost_chart.h
//
// Twins are hidden by nearer spheres, but not by their own. In a periodic domain each is drawn at the image that is
// nearest to its sphere. Cost: proportional to the number of spheres; of more than kMaxTwins only the lines are drawn.
#include <cmath>
#include <numbers>

#include "core/numbers.h"
#include "core/phrase.h"
#include "render/ghost_chart.h"
#include "render/overlays/overlay.h"

namespace ballpit {

namespace {

constexpr float kClose = 0.05f;  // radii: nearer twins are not drawn
constexpr size_t kMaxTwins = 3000;
constexpr float kCrowdOfTwins = 600;  // of more spheres that are apart, lines are fainter
constexpr int kSides = 8;             // of half a twin's outline: it is filled as a polygon of twice as many
constexpr float kTwinTint = 0.3f;
constexpr float kRoom = 0.2f;  // of the picture's height, for the curve
// [1/1080 of the picture's height]
constexpr float kWidth = 3, kRim = 1.5f, kDash = 9, kMarked = 26, kPad = 10, kRight = 30;

/// A circle that faces the viewer, spanned by two vectors as long as its radius.
struct Circle {
  Vec3 centre, right, up;
  Vec3 at(float turn) const {
    const float angle = 2 * std::numbers::pi_v<float> * turn;
    return centre + std::cos(angle) * right + std::sin(angle) * up;
  }
};

/// The outline of a sphere, in front of it.
Circle outline_of(const Vec3& centre, float radius, const Camera& camera, const Projection& projection) {
  const float lift = 1.02f * radius, distance = length(centre - camera.eye);
  const Vec3 look = normalize(camera.is_orthographic() ? camera.target - camera.eye : centre - camera.eye);
  float shown = radius;
  if (!camera.is_orthographic()) {
    shown *= (distance - lift) / std::sqrt(std::max(distance * distance - radius * radius, 1e-12f * radius * radius));
  }
  const Vec3 right = normalize(glm::cross(look, camera.up));
  return {projection.lift(centre, lift), shown * right, shown * glm::cross(right, look)};
}

/// Fills a circle: a regular polygon of 2n sides consists of n(n−1)/2 parallelograms, one for each two of its
/// directions.
void add_disc(const Circle& circle, Rgba color, std::vector<Face>& faces) {
  const auto corner = [&](int k) { return circle.at(static_cast<float>(k) / (2 * kSides)); };
  for (int b = 1; b < kSides; ++b) {
    for (int a = 0; a < b; ++a) {
      const Vec3 u = corner(a + 1) - corner(a), v = corner(b + 1) - corner(b);
      faces.push_back({corner(0) + corner(b) - corner(a + 1), u, v, color});
    }
  }
}

void add_dotted(const Circle& circle, int dashes, Rgba color, std::vector<Line>& lines) {
  for (int k = 0; k < dashes; ++k) {
    const auto at = [&](float part) { return circle.at((static_cast<float>(k) + part) / static_cast<float>(dashes)); };
    lines.push_back({at(0), color, at(0.55f), color});
  }
}

void draw_twins(const GhostInspection& ghost, const FrameView& view, Painter& painter) {
  const BodySnapshot& bodies = view.inspection.bodies;
  const Projection projection(view.camera, painter.sheet);
  const Rgba color = to_rgba(painter.theme.reference), tint = to_rgba(painter.theme.reference, kTwinTint);
  const float scale = line_scale(view, projection, painter.sheet.unit());
  std::vector<Line> lines;
  std::vector<Face> faces;
  size_t twins = 0;
  const auto is_apart = [&](int64_t i) {
    return length(ghost.ahead[static_cast<size_t>(i)]) >= kClose * bodies.radius_of(i);
  };
  int64_t apart = 0;
  for (int64_t i = 0; i < bodies.count; ++i) apart += is_apart(i);
  const Rgba line_color =
      to_rgba(painter.theme.reference,
              std::clamp(kCrowdOfTwins / static_cast<float>(std::max<int64_t>(apart, 1)), 0.25f, 1.0f));
  for (int64_t i = 0; i < bodies.count; ++i) {
    const Vec3 from = bodies.position_of(i), ahead = ghost.ahead[static_cast<size_t>(i)], to = from + ahead;
    const float radius = bodies.radius_of(i);
    if (!is_apart(i) || !projection.sees(from) || !projection.sees(to)) continue;
    lines.push_back(
        {projection.lift(from, 1.02f * radius), line_color, projection.lift(to, 1.02f * radius), line_color});
    if (++twins > kMaxTwins) continue;
    const Circle circle = outline_of(to, radius, view.camera, projection);
    const float around = 2 * std::numbers::pi_v<float> * projection.length_at(to, radius);
    add_dotted(circle, std::clamp(static_cast<int>(around / (2 * kDash * painter.sheet.unit())), 8, 64), color, lines);
    add_disc(circle, tint, faces);
  }
  painter.faces.draw(faces);
  painter.draw_rimmed(lines, painter.theme.background, scale * kWidth, scale * kRim);
}

void draw_wrong(const WrongCollision& wrong, const FrameView& view, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const Projection projection(view.camera, sheet);
  if (projection.sees(wrong.place)) {
    const float u = sheet.unit();
    const Vec2 at = projection.at(wrong.place);
    for (const float radius : {kMarked, kMarked + 9}) {
      sheet.ring(at, radius * u, painter.ground(), 8 * u);
      sheet.ring(at, radius * u, to_rgba(painter.theme.missed), 4 * u);
    }
    const bool is_left = at.x > 0.6f * static_cast<float>(sheet.width());
    sheet.bordered_text(at + Vec2(is_left ? -1 : 1, 0) * (kMarked + 20) * u, is_left ? Anchor{1, 0.5f} : kLeft,
                        painter.ink(), painter.ground(), timing_text(wrong), TextSize::small);
  }
  painter.note({{Swatch::twice, painter.theme.missed, translated("first wrong collision:")},
                {Swatch::none, {}, bodies_text(wrong)},
                {Swatch::none, {}, time_text(wrong.time)},
                {Swatch::none, {}, timing_text(wrong)}});
}

void draw_curve(const std::vector<Vec2>& curve, Vec2 low, Vec2 size, Rgba color, float width, Sheet& sheet) {
  for (size_t k = 1; k < curve.size(); ++k) {
    const auto at = [&](const Vec2& p) { return low + Vec2(p.x * size.x, (1 - p.y) * size.y); };
    sheet.line(at(curve[k - 1]), at(curve[k]), color, width);
  }
}

/// A line of samples and texts; returns where it ends.
float draw_legend(const std::vector<NotePart>& parts, Vec2 at, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  for (const NotePart& part : parts) {
    const Vec2 end = at + Vec2(40 * u, 0);
    if (part.swatch == Swatch::bold) sheet.line(at, end, to_rgba(part.color), 5 * u);
    if (part.swatch == Swatch::line) sheet.line(at, end, to_rgba(part.color), 2.5f * u);
    if (part.swatch == Swatch::stub) sheet.dotted(at, end, to_rgba(part.color), 5 * u);
    if (part.swatch != Swatch::none) at.x += 52 * u;
    sheet.text(at, kLeft, painter.ink(), part.text, TextSize::small);
    at.x += sheet.size_of(part.text, TextSize::small).x + 28 * u;
  }
  return at.x;
}

void draw_chart(const GhostInspection& ghost, Painter& painter) {
  const GhostChart chart = chart_of(ghost);
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), line = sheet.size_of("0", TextSize::small).y;
  const float height = kRoom * static_cast<float>(sheet.height());
  const float top = painter.take_strip(height + 2 * line + 3 * kPad * u);
  std::vector<NotePart> legend{{Swatch::none, {}, translated("distance from exact motion [radii]")},
                               {Swatch::bold, painter.theme.text, translated("median")},
                               {Swatch::line, painter.theme.text, translated("largest")}};
  if (chart.growth) {
    legend.push_back({Swatch::stub, painter.theme.reference,
                      phrase("Lyapunov, λ = {} /s", local_number(fmt::format("{:.3g}", ghost.growth)))});
  }
  draw_legend(legend, {kPad * u, top + kPad * u + line / 2}, painter);

  const float labels = std::max(sheet.size_of("10⁻¹⁶", TextSize::small).x, 0.0f) + 2 * kPad * u;
  const Vec2 low(labels, top + 2 * kPad * u + line),
      size(static_cast<float>(sheet.width()) - labels - kRight * u, height), high = low + size;
  const Rgba faint = to_rgba(painter.theme.reference);
  const auto y_of = [&](int power) { return low.y + (1 - chart.height_of(std::pow(10.0, power))) * size.y; };
  float last = high.y + 2 * line;
  for (const int power : {chart.low, 0, chart.high, (chart.low + chart.high) / 2}) {
    const float y = y_of(power);
    if (power < chart.low || power > chart.high) continue;
    const bool is_end = power == chart.low || power == chart.high;
    if (!is_end && (std::fabs(y - low.y) < 0.9f * line || std::fabs(y - high.y) < 0.9f * line ||
                    std::fabs(y - last) < 0.9f * line)) {
      continue;
    }
    last = is_end ? last : y;
    sheet.line({low.x - 6 * u, y}, {high.x, y}, to_rgba(painter.theme.reference, is_end ? 1 : 0.5f), 1.5f * u);
    sheet.text({low.x - kPad * u, y},
               {1, power == chart.low    ? 0.75f
                   : power == chart.high ? 0.25f
                                         : 0.5f},
               painter.ink(), ten_to_the(power), TextSize::small);
  }
  sheet.line(low, {low.x, high.y}, faint, 1.5f * u);
  sheet.text({low.x, high.y + kPad * u / 2}, kUpperLeft, painter.ink(), time_text(chart.from), TextSize::small);
  if (chart.to > chart.from) {
    sheet.text({high.x, high.y + kPad * u / 2}, kUpperRight, painter.ink(), time_text(chart.to), TextSize::small);
  }
  const auto at = [&](const Vec2& p) { return low + Vec2(p.x * size.x, (1 - p.y) * size.y); };
  if (chart.wrong) {
    const Rgba color = to_rgba(painter.theme.missed);
    const float x = at({*chart.wrong, 0}).x;
    for (const float side : {-4.0f, 4.0f}) sheet.line({x + side * u, low.y}, {x + side * u, high.y}, color, 3 * u);
  }
  if (chart.growth) sheet.dotted(at((*chart.growth)[0]), at((*chart.growth)[1]), faint, 5 * u);
  draw_curve(chart.largest, low, size, painter.ink(), 2.5f * u, sheet);
  draw_curve(chart.median, low, size, painter.ink(), 5 * u, sheet);
}

/// Not where exact motion has never run.
bool has_chart(const GhostInspection& ghost) { return ghost.lack.empty() || ghost.curve.size() > 1; }

}  // namespace

float ghost_room(const Inspection& inspection, float text_scale) {
  if (!inspection.ghost || !has_chart(*inspection.ghost)) return 0;
  return kRoom + (2 * line_height(TextSize::small, text_scale) + 3 * kPad) / 1080;
}

void draw_ghost(const FrameView& view, Painter& painter) {
  if (!view.inspection.ghost) return;
  const GhostInspection& ghost = *view.inspection.ghost;
  if (!ghost.ahead.empty()) {
    draw_twins(ghost, view, painter);
    painter.note({{Swatch::pale, painter.theme.reference, translated("where exact motion has them")}});
  }
  if (ghost.is_exact) painter.note("this motion is exact too: only rounding parts them");
  if (ghost.overlap > 0.01 && ghost.lack.empty()) {
    painter.note({{Swatch::none, {}, translated("it began with overlap:")},
                  {Swatch::none, {}, phrase("{} % of a radius", std::lround(100 * ghost.overlap))}});
  }
  if (ghost.is_unwatched) painter.note("first wrong collision: unknown, steps were left out");
  if (ghost.wrong) draw_wrong(*ghost.wrong, view, painter);
  if (has_chart(ghost)) draw_chart(ghost, painter);
}

}  // namespace ballpit
