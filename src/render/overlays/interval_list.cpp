// SPDX-License-Identifier: MIT
#include "render/overlays/interval_list.h"

#include <algorithm>

#include <fmt/format.h>

namespace ballpit {

namespace {

constexpr float kBoxHeight = 40, kAbove = 46, kBelow = 12;  // [1/1080 of the picture's height]

void draw_box(const Endpoint& endpoint, size_t k, const Row& row, bool walks, bool is_met, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const Theme& theme = painter.theme;
  const float u = sheet.unit();
  const Rgba edge = endpoint.is_end && !walks ? to_rgba(theme.idle) : to_rgba(theme.begin);
  Rgba text = endpoint.is_end ? painter.ink(0.7f) : painter.ink();
  const Vec2 low = row.low(k) + Vec2(1.5f * u, 0), high = row.high(k) - Vec2(1.5f * u, 0);
  if (walks && !endpoint.is_end) {
    sheet.box(low, high, edge);
    text = to_rgba(Vec3(1));
  } else if (is_met) {
    sheet.box(low, high, to_rgba(theme.candidate));
    text = to_rgba(theme.on_body);
  } else if (endpoint.is_end) {
    sheet.box(low, high, to_rgba(theme.idle, 0.18f));
  }
  sheet.frame(low, high, edge, (walks ? 4 : 2) * u);
  sheet.text((low + high) / 2.0f, kCentre, text, name_of(endpoint), TextSize::small);
  if (endpoint.is_end && !walks) {  // its thread ends at once
    const Vec2 foot(row.middle(k), row.top), head = foot - Vec2(0, 10 * u);
    sheet.line(foot, head, to_rgba(theme.idle), 3 * u);
    sheet.line(head - Vec2(7 * u, 0), head + Vec2(7 * u, 0), to_rgba(theme.idle), 3 * u);
  }
}

/// From the thread's begin up, along the list and down on its end.
void draw_walk(const Walk& walk, const Row& row, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), width = 4 * u, above = row.top - 28 * u;
  const Rgba color = to_rgba(painter.theme.begin);
  const Vec2 begin(row.middle(walk.first), row.top), end(row.middle(walk.last), row.top - 2 * u);
  sheet.line(begin, {begin.x, above - width / 2}, color, width);
  sheet.line({begin.x, above}, {end.x + width / 2, above}, color, width);
  sheet.arrow({end.x, above}, end, color, width);
}

}  // namespace

std::string name_of(const Endpoint& endpoint) {
  return fmt::format("{}{}", endpoint.is_end ? 'e' : 'b', endpoint.body);
}

Walk shown_walk(const std::vector<Endpoint>& endpoints, int64_t selected) {
  // The walk of a body meets the begins up to its end, without those up to its own begin.
  Walk walk;
  std::vector<std::pair<int, size_t>> begin(
      endpoints.size());  // of each body: number of begins so far, entry in the list
  int begins = 0, max = -1;
  for (size_t k = 0; k < endpoints.size(); ++k) {
    const auto body = static_cast<size_t>(endpoints[k].body);
    if (body >= begin.size()) continue;
    if (!endpoints[k].is_end) {
      begin[body] = {++begins, k};
    } else if (begin[body].first > 0 &&
               (selected < 0 ? begins - begin[body].first > max : endpoints[k].body == selected)) {
      max = begins - begin[body].first;
      walk = {endpoints[k].body, begin[body].second, k, {}};
    }
  }
  if (walk.body < 0) return walk;
  for (size_t k = walk.first + 1; k < walk.last; ++k) {
    if (!endpoints[k].is_end) walk.met.push_back(k);
  }
  return walk;
}

std::optional<Row> take_row(const std::vector<Endpoint>& endpoints, Painter& painter) {
  const Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), width = static_cast<float>(sheet.width()) - 32 * u;
  float text = 0;
  for (const Endpoint& endpoint : endpoints) text = std::max(text, sheet.size_of(name_of(endpoint), TextSize::small).x);
  const float box = std::min(width / static_cast<float>(endpoints.size()), std::max(64 * u, text + 12 * u));
  if (endpoints.size() > kMaxLabels || box < text + 5 * u) return std::nullopt;
  const float height = std::max(kBoxHeight * u, sheet.size_of("0", TextSize::small).y + 6 * u);
  const Strip strip = painter.take_strip((kAbove + kBelow) * u + height);
  const float left = (static_cast<float>(sheet.width()) - box * static_cast<float>(endpoints.size())) / 2;
  return Row{left, box, strip.top + kAbove * u, strip.top + kAbove * u + height};
}

void draw_list(const std::vector<Endpoint>& endpoints, const Walk& walk, const Row& row, Painter& painter) {
  for (size_t k = 0; k < endpoints.size(); ++k) {
    const bool is_met = std::binary_search(walk.met.begin(), walk.met.end(), k);
    draw_box(endpoints[k], k, row, walk.body >= 0 && endpoints[k].body == walk.body, is_met, painter);
  }
  if (walk.body >= 0) draw_walk(walk, row, painter);
}

}  // namespace ballpit
