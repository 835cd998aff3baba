// SPDX-License-Identifier: MIT
// Shows the candidates of the broad phase and which of them are contacts, as lines between centres.
//
//     o ───── o   candidate that does not touch: thin, sky, from surface to surface
//     o━━━━━━━o   contact: bold, orange with a dark core, from centre to centre
//     ◎═══════◎   contact that the method missed: double, vermillion, a ring around both
//
// In space, candidates are hidden by nearer spheres and fade with depth, and more so the more there are. Contacts are
// in front of their own two spheres. Missed contacts, and the candidates of the selected sphere, are in front of
// everything. Cost: proportional to the number of pairs. More than kMaxCandidates candidates are only counted.
#include <cmath>
#include <iterator>
#include <tuple>

#include "core/phrase.h"
#include "render/overlays/overlay.h"
#include "render/page_view.h"

namespace ballpit {

namespace {

// [1/1080 of the picture's height]
constexpr float kThin = 3, kBold = 7, kEdge = 4, kRim = 2, kGap = 5, kDouble = 4, kRing = 5, kCasing = 2.5f;
constexpr float kShortest = 14;  // of a candidate's line, so that it is visible between spheres that almost touch
constexpr size_t kMaxRings = 2000;
constexpr float kCrowdOfPairs = 300;  // of more candidates in space, each is fainter
constexpr float kManyFlat = 60;       // of more candidates in the plane, each is thinner

bool before(const Pair& a, const Pair& b) { return std::tie(a.i, a.j) < std::tie(b.i, b.j); }

/// The image of the second sphere that is nearest to the first; in a periodic domain it may lie beyond the border.
Vec3 nearest_image(const BodySnapshot& bodies, const Pair& pair, const DomainBox& domain) {
  const Vec3 from = bodies.position_of(pair.i), size = domain.max - domain.min;
  Vec3 to = bodies.position_of(pair.j);
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    if (std::abs(to[axis] - from[axis]) > size[axis] / 2) to[axis] -= std::copysign(size[axis], to[axis] - from[axis]);
  }
  return to;
}

/// The image of the second sphere that touches the first. Touching across a periodic border, each has one of the other.
Vec3 touching_image(const BodySnapshot& bodies, const Pair& pair, const DomainBox& domain) {
  const Vec3 from = bodies.position_of(pair.i), to = bodies.position_of(pair.j);
  if (length(to - from) <= 1.1f * (bodies.radius_of(pair.i) + bodies.radius_of(pair.j))) return to;
  return nearest_image(bodies, pair, domain);
}

/// The line of a contact, from the centre of i to `end`, in front of both spheres; longer by `beyond` [pixel] at both
/// ends. It is visible as a whole, even if one sphere stands behind the other.
Line lifted(const BodySnapshot& bodies, const Pair& pair, Vec3 end, const Projection& projection, Rgba color,
            float beyond) {
  const float way = 1.02f * std::max(bodies.radius_of(pair.i), bodies.radius_of(pair.j));
  Vec3 start = bodies.position_of(pair.i);
  const auto behind = [&](const Vec3& a, const Vec3& b) {
    return std::max(0.0f, projection.depth(a) - projection.depth(b));
  };
  const float distance = length(end - start);
  if (beyond > 0 && distance > 0) {
    const Vec3 more = beyond / projection.length_at(start, distance) * (end - start);
    start -= more;
    end += more;
  }
  return {projection.lift(start, way + behind(start, end)), color, projection.lift(end, way + behind(end, start)),
          color};
}

/// The part of the line of centres between the surfaces, [m]; a short one is extended into the spheres.
std::pair<Vec3, Vec3> between_surfaces(const BodySnapshot& bodies, const Pair& pair, const DomainBox& domain,
                                       float shortest) {
  const Vec3 a = bodies.position_of(pair.i);
  const Vec3 b = domain.is_periodic ? nearest_image(bodies, pair, domain) : bodies.position_of(pair.j);
  const float distance = length(b - a);
  if (!(distance > 0)) return {a, b};
  const float r = bodies.radius_of(pair.i), s = bodies.radius_of(pair.j);
  const float inside = std::clamp((shortest - (distance - r - s)) / 2, 0.0f, std::min(r, s));
  const Vec3 along = (b - a) / distance;
  return {a + (r - inside) * along, b - (s - inside) * along};
}

/// The end of a line from `from` to `to` that stops a little beyond the border of the domain.
Vec3 cut_at_border(const Vec3& from, const Vec3& to, const DomainBox& domain) {
  constexpr float kBeyond = 0.02f;  // of the domain's longest edge
  float part = 1;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    const float beyond = kBeyond * domain.longest_edge(), way = to[axis] - from[axis];
    const float border = way > 0 ? domain.max[axis] + beyond : domain.min[axis] - beyond;
    if (std::abs(way) > 0) part = std::min(part, std::max(0.0f, (border - from[axis]) / way));
  }
  return from + part * (to - from);
}

/// The line of a candidate; two lines if it crosses a periodic border.
std::vector<std::pair<Vec3, Vec3>> lines_of(const FrameView& view, const Pair& pair, float shortest) {
  const BodySnapshot& bodies = view.inspection.bodies;
  const auto [from, to] = between_surfaces(bodies, pair, view.domain, shortest);
  if (!view.domain.is_periodic || nearest_image(bodies, pair, view.domain) == bodies.position_of(pair.j)) {
    return {{from, to}};
  }
  const auto [back_from, back_to] = between_surfaces(bodies, {pair.j, pair.i}, view.domain, shortest);
  return {{from, cut_at_border(from, to, view.domain)}, {back_from, cut_at_border(back_from, back_to, view.domain)}};
}

void draw_apart(const FrameView& view, const std::vector<Pair>& apart, Painter& painter, const Projection& projection,
                float scale) {
  const BodySnapshot& bodies = view.inspection.bodies;
  const bool is_planar = view.domain.is_planar();
  const float crowd = is_planar ? 1 : std::sqrt(std::min(1.0f, kCrowdOfPairs / static_cast<float>(apart.size() + 1)));
  std::vector<Line> lines;
  std::vector<std::pair<Vec3, Vec3>> picked;
  for (const Pair& pair : apart) {
    const Vec3 centre = bodies.position_of(pair.i);
    if (!projection.sees(centre) || !projection.sees(bodies.position_of(pair.j))) continue;
    const float shortest = kShortest * painter.sheet.unit() / projection.length_at(centre, 1);
    for (const auto& [from, to] : lines_of(view, pair, shortest)) {
      if (pair.i == view.selected || pair.j == view.selected) {
        picked.emplace_back(from, to);
        continue;
      }
      const auto color_at = [&](const Vec3& point) {
        const float fade = is_planar ? 1 : fade_at(point, view.domain.min, view.domain.max, view.camera);
        return to_rgba(painter.theme.candidate, crowd * fade);
      };
      lines.push_back({from, color_at(from), to, color_at(to)});
    }
  }
  const float many = std::sqrt(kManyFlat / static_cast<float>(apart.size() + 1));
  const float width = is_planar ? std::clamp(many, 0.5f, 1.0f) : scale;
  painter.draw_rimmed(lines, rim_of(painter.theme.candidate), width * kThin, width * kRim);
  const float u = painter.sheet.unit();
  for (const auto& [from, to] : picked) {
    const Vec2 a = projection.at(from), b = projection.at(to);
    painter.sheet.line(a, b, to_rgba(rim_of(painter.theme.candidate)), (kThin + 3 * kRim) * u);
    painter.sheet.line(a, b, to_rgba(painter.theme.candidate), 1.3f * kThin * u);
  }
}

/// The pairs, each once for every end that is drawn on its own: twice if it touches across a periodic border.
std::vector<Pair> with_both_ends(const std::vector<Pair>& pairs, const FrameView& view) {
  std::vector<Pair> all = pairs;
  const BodySnapshot& bodies = view.inspection.bodies;
  for (const Pair& pair : pairs) {
    if (touching_image(bodies, pair, view.domain) != bodies.position_of(pair.j)) all.push_back({pair.j, pair.i});
  }
  return all;
}

void draw_contacts(const FrameView& view, Painter& painter, const Projection& projection, float scale) {
  const BodySnapshot& bodies = view.inspection.bodies;
  // A dark core separates the line from the spheres, which are orange too.
  const Rgba color = to_rgba(rim_of(painter.theme.contact)), edge = to_rgba(painter.theme.contact);
  std::vector<Line> lines, edges;
  for (const Pair& pair : with_both_ends(view.inspection.contacts, view)) {
    const Vec3 end = touching_image(bodies, pair, view.domain);
    lines.push_back(lifted(bodies, pair, end, projection, color, 0));
    edges.push_back(lifted(bodies, pair, end, projection, edge, scale * kEdge * painter.sheet.unit()));
  }
  painter.lines.draw(edges, scale * (kBold + 2 * kEdge) * painter.line_unit);
  painter.lines.draw(lines, scale * kBold * painter.line_unit);
}

void draw_missed(const FrameView& view, Painter& painter, const Projection& projection, float scale) {
  const BodySnapshot& bodies = view.inspection.bodies;
  Sheet& sheet = painter.sheet;
  const float u = std::max(scale, 0.4f) * sheet.unit();
  const Rgba color = to_rgba(painter.theme.missed), ground = to_rgba(painter.theme.background);
  std::vector<Pair> missed = view.inspection.missed;
  missed.resize(std::min(missed.size(), kMaxRings));
  for (const Pair& pair : with_both_ends(missed, view)) {
    const Vec3 centre = bodies.position_of(pair.i), end = touching_image(bodies, pair, view.domain);
    if (!projection.sees(centre) || !projection.sees(end)) continue;
    const Vec2 a = projection.at(centre), b = projection.at(end), way = b - a;
    const Vec2 across = length(way) > 0 ? Vec2(-way.y, way.x) / length(way) : Vec2(0, 1);
    const Vec2 beside = std::max(kGap * u, 1.5f) * across;
    sheet.line(a, b, ground, 2 * (kGap + kDouble / 2 + kCasing) * u);
    for (const Vec2& offset : {beside, -beside}) sheet.line(a + offset, b + offset, color, kDouble * u);
    for (const int32_t body : {pair.i, pair.j}) {
      const Vec3 at = bodies.position_of(body);
      const float beyond = (kGap + kRing / 2) * u + (body == view.selected ? 8 * sheet.unit() : 0);
      const float radius = projection.length_at(at, bodies.radius_of(body)) + beyond;
      sheet.ring(projection.at(at), radius, ground, (kRing + 2 * kCasing) * u);
      sheet.ring(projection.at(at), radius, color, kRing * u);
    }
  }
}

void draw_notes(const FrameView& view, size_t apart, Painter& painter) {
  const Inspection& inspection = view.inspection;
  const Theme& theme = painter.theme;
  const auto count = [](size_t n) { return static_cast<int64_t>(n); };
  if (view.left_out.missed) painter.note("Pairs: too many spheres to look for missed contacts");
  if (view.left_out.candidates) {
    painter.note({{Swatch::none, {}, translated("too many candidates to draw; show fewer spheres")},
                  {Swatch::bold, theme.contact, counted(count(inspection.contacts.size()), "contact")}});
    return;
  }
  const bool is_before_tests = view.page && !view.page->code.empty() && inspection.candidates.empty();
  if (is_before_tests) return;
  const bool too_many = apart > kMaxCandidates;
  painter.note({{Swatch::none, {}, counted(count(apart + inspection.contacts.size()), "candidate") + ":"},
                {too_many ? Swatch::none : Swatch::line, theme.candidate,
                 phrase(too_many ? "{} apart (too many to draw)" : "{} apart", grouped(count(apart)))},
                {Swatch::bold, theme.contact, counted(count(inspection.contacts.size()), "contact")}});
  if (!inspection.missed.empty()) {
    const size_t missed = inspection.missed.size();
    painter.note({{Swatch::twice, theme.missed,
                   phrase(missed == 1 ? "{} contact missed" : "{} contacts missed", grouped(count(missed))) +
                       (missed > kMaxRings ? phrase(", {} of them drawn", grouped(count(kMaxRings))) : "")}});
  }
}

}  // namespace

std::vector<Pair> candidates_apart(const Inspection& inspection) {
  std::vector<Pair> apart;
  std::set_difference(inspection.candidates.begin(), inspection.candidates.end(), inspection.contacts.begin(),
                      inspection.contacts.end(), std::back_inserter(apart), before);
  return apart;
}

void draw_pairs(const FrameView& view, Painter& painter) {
  const Inspection& inspection = view.inspection;
  const Projection projection(view.camera, painter.sheet);
  const float scale = line_scale(view, projection, painter.sheet.unit());
  const std::vector<Pair> apart = candidates_apart(inspection);
  if (apart.size() <= kMaxCandidates) draw_apart(view, apart, painter, projection, scale);
  draw_contacts(view, painter, projection, scale);
  draw_missed(view, painter, projection, scale);
  draw_notes(view, apart.size(), painter);
}

}  // namespace ballpit
