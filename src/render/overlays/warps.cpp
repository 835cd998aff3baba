// SPDX-License-Identifier: MIT
// Shows the threads of a search as a GPU runs them: warps of 32 lanes in lockstep. Each lane is a column, each step a
// row; a lane whose thread is done waits for the longest one of its warp.
//
//          █ · · · │ · · █ ·
//          █ · █ · │ · · █ ·       █ a thread that walks     · a lane that waits
//          █ · █ █ │ █ · █ ·       a stub: a thread that ends at once
//          █ _ █ █ │ █ _ █ _
//          warp 0    warp 1
//
// A few warps, evenly chosen among all, are shown to one scale.
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/phrase.h"
#include "render/overlays/overlay.h"

namespace ballpit {

namespace {

constexpr size_t kMaxWarps = 4, kLanes = 32;  // of a warp, on NVIDIA GPUs
constexpr float kRoom = 0.27f;                // of the picture's height, for the lanes
// [1/1080 of the picture's height]
constexpr float kMargin = 24, kWarpGap = 30, kPad = 8;
constexpr float kSmallestBar = 10;  // steps that are lower than this are drawn as one bar

/// The lanes of one warp, from `corner`, its lower left.
struct WarpBox {
  Vec2 corner;
  float lane, step;  // [pixel]
  int longest;
};

void draw_lane(const WarpBox& warp, size_t lane, int work, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), gap = std::min(1.5f * u, 0.1f * warp.lane);
  const float left = warp.corner.x + static_cast<float>(lane) * warp.lane;
  const auto fill = [&](int from, int to, bool is_busy) {
    if (from >= to) return;
    const Vec2 low(left + gap, warp.corner.y - static_cast<float>(to) * warp.step + gap / 2);
    const Vec2 high(left + warp.lane - gap, warp.corner.y - static_cast<float>(from) * warp.step - gap / 2);
    sheet.box(low, high, to_rgba(is_busy ? painter.theme.begin : painter.theme.idle, is_busy ? 1 : kPale));
    if (!is_busy) sheet.frame(low, high, to_rgba(painter.theme.idle), 1.5f * u);
  };
  const bool has_squares = warp.step >= kSmallestBar * u;
  const auto fill_steps = [&](int from, int to, bool is_busy) {
    if (!has_squares) return fill(from, to, is_busy);
    for (int k = from; k < to; ++k) fill(k, k + 1, is_busy);
  };
  fill_steps(0, work, true);
  fill_steps(work, warp.longest, false);
  if (work == 0) {
    sheet.box({left + gap, warp.corner.y}, {left + warp.lane - gap, warp.corner.y + 5 * u},
              to_rgba(painter.theme.idle));
  }
}

std::vector<int> lanes_of(const std::vector<int>& work, size_t warp) {
  const auto place = [&](size_t k) { return work.begin() + static_cast<ptrdiff_t>(std::min(k, work.size())); };
  return {place(warp * kLanes), place((warp + 1) * kLanes)};
}

/// The share of the lanes' steps in which their threads walk.
float busy_share(const std::vector<int>& lanes, int longest) {
  const int sum = std::accumulate(lanes.begin(), lanes.end(), 0);
  return longest > 0 ? static_cast<float>(sum) / (kLanes * static_cast<float>(longest)) : 0;
}

}  // namespace

float warps_room(const Inspection& inspection, float text_scale) {
  return inspection.work.empty() ? 0 : kRoom + (2 * line_height(TextSize::small, text_scale) + kPad) / 1080;
}

void draw_warps(const FrameView& view, Painter& painter) {
  const std::vector<int>& work = view.inspection.work;
  if (work.empty()) return;
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), line = sheet.size_of("0", TextSize::small).y;
  const size_t all = (work.size() + kLanes - 1) / kLanes, shown = std::min(all, kMaxWarps);
  const float height = kRoom * static_cast<float>(sheet.height()) - 2 * kPad * u;
  const float bottom = painter.take_strip(height + 2 * line + 3 * kPad * u) + kPad * u + height;
  const float lane = ((static_cast<float>(sheet.width()) - 2 * kMargin * u + kWarpGap * u) / kMaxWarps - kWarpGap * u) /
                     static_cast<float>(kLanes);
  std::vector<size_t> chosen;
  int most = 1;
  for (size_t k = 0; k < shown; ++k) {
    chosen.push_back(all > shown ? (2 * k + 1) * all / (2 * shown) : k);
    for (const int steps : lanes_of(work, chosen.back())) most = std::max(most, steps);
  }
  const float step = std::min(height / static_cast<float>(most), 2 * lane);
  for (size_t k = 0; k < shown; ++k) {
    const size_t w = chosen[k];
    const std::vector<int> lanes = lanes_of(work, w);
    const float left = kMargin * u + static_cast<float>(k) * (kLanes * lane + kWarpGap * u);
    const WarpBox warp{{left, bottom}, lane, step, *std::max_element(lanes.begin(), lanes.end())};
    for (size_t at = 0; at < lanes.size(); ++at) draw_lane(warp, at, lanes[at], painter);
    const std::string text =
        phrase("warp {}: {} steps, {} % busy", w, warp.longest, std::lround(100 * busy_share(lanes, warp.longest)));
    const size_t comma = std::min(text.find(", "), text.size());  // the share is in a line of its own
    const Vec2 foot(left + kLanes * lane / 2, bottom + kPad * u);
    sheet.text(foot, kTop, painter.ink(), text.substr(0, comma), TextSize::small);
    if (comma < text.size()) {
      sheet.text(foot + Vec2(0, line), kTop, painter.ink(), text.substr(comma + 2), TextSize::small);
    }
  }
  painter.note({{Swatch::square, painter.theme.begin, translated("walks")},
                {Swatch::pale, painter.theme.idle, translated("waits")}});
  if (shown < all) painter.note(phrase("{} of {} warps", shown, all));
}

}  // namespace ballpit
