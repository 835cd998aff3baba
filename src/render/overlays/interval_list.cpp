// SPDX-License-Identifier: MIT
#include "render/overlays/interval_list.h"

#include <fmt/format.h>

namespace ballpit {

namespace {

// [1/1080 of the picture's height]
constexpr float kEntryPadding = 6, kWidestEntry = 150;  // of a box
constexpr float kBelow = 42;                            // for the walk
constexpr float kDepth = 28, kLevel = 9;                // of a walk below the list; from one to the next above it
constexpr float kStub = 10, kAside = 22;                // beside the heads of walks

constexpr size_t kMaxStacked = 2 * 10;  // in a longer list, the letters of names stand above the numbers

/// [1/1080 of the picture's height] of a box.
float box_height(size_t entries, float text_scale) {
  const float line = line_height(TextSize::small, text_scale);
  return (entries > kMaxStacked ? 1.8f * line : line) + 2 * kEntryPadding;
}

void draw_name(const Endpoint& endpoint, Vec2 middle, bool is_stacked, Rgba color, Sheet& sheet) {
  const std::string name = name_of(endpoint);
  if (!is_stacked) return sheet.text(middle, kCentre, color, name, TextSize::small);
  const Vec2 up(0, 0.4f * sheet.size_of("0", TextSize::small).y);
  sheet.text(middle - up, kCentre, color, name.substr(0, 1), TextSize::small);
  sheet.text(middle + up, kCentre, color, name.substr(1), TextSize::small);
}

/// `stub`: where it is, from the middle of the box [pixel]; none if negative.
void draw_box(const Endpoint& endpoint, size_t k, const Row& row, bool walks, bool is_met, float stub,
              Painter& painter) {
  Sheet& sheet = painter.sheet;
  const Theme& theme = painter.theme;
  const float u = sheet.unit();
  const Rgba edge = endpoint.is_end && !walks ? to_rgba(theme.idle) : to_rgba(theme.begin);
  Rgba text = painter.ink();
  const Vec2 low = row.low(k) + Vec2(1.5f * u, 0), high = row.high(k) - Vec2(1.5f * u, 0);
  if (walks && !endpoint.is_end) {
    sheet.box(low, high, edge);
    text = to_rgba(text_on(theme.begin));
  } else if (is_met) {
    sheet.box(low, high, to_rgba(theme.candidate));
    text = to_rgba(text_on(theme.candidate));
  } else if (endpoint.is_end) {
    sheet.box(low, high, to_rgba(theme.idle, 0.18f));
  }
  sheet.frame(low, high, edge, (walks ? 4 : 2) * u);
  draw_name(endpoint, (low + high) / 2.0f, row.is_stacked, text, sheet);
  if (stub >= 0 && endpoint.is_end && !walks) {  // its thread ends at once
    const Vec2 foot(row.middle(k) + stub, row.bottom), head = foot + Vec2(0, kStub * u);
    sheet.line(foot, head, to_rgba(theme.idle), 3 * u);
    sheet.line(head - Vec2(7 * u, 0), head + Vec2(7 * u, 0), to_rgba(theme.idle), 3 * u);
  }
}

/// From the thread's begin down, along the list and up to its end; on one of several levels.
void draw_walk(const Walk& walk, const Row& row, float level, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), width = 4 * u, below = row.bottom + (kDepth - kLevel * level) * u;
  const Rgba color = to_rgba(painter.theme.begin);
  const Vec2 begin(row.middle(walk.first), row.bottom), end(row.middle(walk.last), row.bottom + 2 * u);
  sheet.line(begin, {begin.x, below + width / 2}, color, width);
  sheet.line({begin.x, below}, {end.x + width / 2, below}, color, width);
  sheet.arrow({end.x, below}, end, color, width);
}

}  // namespace

std::string name_of(const Endpoint& endpoint) {
  return fmt::format("{}{}", endpoint.is_end ? 'e' : 'b', endpoint.body);
}

float list_height(size_t entries, float text_scale) { return box_height(entries, text_scale) + kBelow; }

std::optional<Row> take_row(const std::vector<Endpoint>& endpoints, float middle, Painter& painter) {
  const Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), width = static_cast<float>(sheet.width()) - 32 * u;
  const bool is_stacked = endpoints.size() > kMaxStacked;
  float text = 0;
  for (const Endpoint& endpoint : endpoints) {
    const std::string name = name_of(endpoint);
    text = std::max(text, sheet.size_of(is_stacked ? name.substr(1) : name, TextSize::small).x);
  }
  const auto count = static_cast<float>(endpoints.size());
  const float box = std::min(width / count, std::max(kWidestEntry * u, text + 12 * u));
  if (endpoints.size() > kMaxLabels || box < text + 3 * u) return std::nullopt;
  const float height = box_height(endpoints.size(), sheet.text_scale()) * u;
  const float top = painter.take_strip(height + kBelow * u);
  const float left = std::clamp(middle - box * count / 2, 16 * u, std::max(16 * u, 16 * u + width - box * count));
  return Row{left, box, top, top + height, is_stacked};
}

void draw_list(const std::vector<Endpoint>& endpoints, const std::vector<Walk>& walks, const Row& row,
               const PageView* page, Painter& painter) {
  const bool has_many = walks.size() > 1;
  const float stub = page && !page->walks ? -1 : has_many ? kAside * painter.sheet.unit() : 0;
  for (size_t k = 0; k < endpoints.size(); ++k) {
    const auto walks_here = [&](const Walk& walk) {
      return endpoints[k].body == walk.body && !(has_many && endpoints[k].is_end);
    };
    const auto meets = [&](const Walk& walk) { return std::binary_search(walk.met.begin(), walk.met.end(), k); };
    draw_box(endpoints[k], k, row, std::ranges::any_of(walks, walks_here),
             !has_many && std::ranges::any_of(walks, meets), stub, painter);
    if (page) mark_touched(*page, "list", static_cast<int64_t>(k), row.low(k), row.high(k), painter);
  }
  for (size_t k = 0; k < walks.size(); ++k) draw_walk(walks[k], row, static_cast<float>(k), painter);
}

std::vector<Walk> shown_walks(const std::vector<Endpoint>& endpoints, int64_t selected, const PageView* page) {
  if (page && !page->walks) return {};
  std::vector<Walk> walks;
  if (page && page->has_walked && selected < 0 && endpoints.size() <= 2 * kMaxWalks) {
    for (const Endpoint& endpoint : endpoints) {
      if (!endpoint.is_end) walks.push_back(shown_walk(endpoints, endpoint.body));
    }
    return walks;
  }
  if (const Walk walk = shown_walk(endpoints, selected); walk.body >= 0) walks.push_back(walk);
  return walks;
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

}  // namespace ballpit
