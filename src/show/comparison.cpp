// SPDX-License-Identifier: MIT
#include "show/comparison.h"

#include <algorithm>
#include <set>

#include "show/view.h"

namespace ballpit {

namespace {

constexpr PictureSize kSmallest{120, 90};  // [pixel] for each view, so that its text can be read
constexpr float kLine = 1.5f / 1080;       // between views, half [of the picture's height]
constexpr float kText = 170.0f / 1080;     // title and figures of a view [of the picture's height]
constexpr float kNearly = 1.1f;  // fewer columns, which fit text better, win where the scene is nearly as large

/// [m] that 1/1000 of the picture's height shows in a view of this width and height [of the picture's height].
float scale_in(const DomainBox& domain, float width, float height) {
  const float free = std::max(height - kText, 0.01f);
  const Camera camera = camera_of({}, domain, width / free);
  return camera.pixel_size(length(camera.target - camera.eye), 1000) / free;
}

}  // namespace

std::vector<BroadPhase> parse_comparison(const std::string& text) {
  const auto& all = kNames<BroadPhase>;
  const std::vector<std::string> known(all.begin() + 1, all.end()), names = split_list(text);  // without "auto"
  const std::string allowed =
      fmt::format("two to {} different ones of {}, with commas between", kMaxCompared, join(known));
  std::vector<BroadPhase> methods;
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end()) throw UserError("--compare", name, allowed);
    methods.push_back(named<BroadPhase>(name));
  }
  const std::set<BroadPhase> different(methods.begin(), methods.end());
  if (methods.size() < 2 || methods.size() > kMaxCompared || different.size() < methods.size()) {
    throw UserError("--compare", text, allowed);
  }
  return methods;
}

void check_compared(const std::vector<GivenOption>& given, std::string_view with) {
  for (const GivenOption& option : given) {
    const bool is_response = option.name == "response" && !option.value.empty();
    const bool needs_none = is_response && (option.value == name_of(Response::automatic) ||
                                            option.value == name_of(Response::event_driven));
    if (option.name != "broadphase" && !needs_none) continue;
    throw UserError("--" + option.name, fmt::format("{} {}", option.value, with),
                    needs_none ? "a response that finds contacts by the broad phase that is named"
                               : "the broad phases of --compare alone");
  }
}

std::vector<GivenOption> with_broad_phase(std::vector<GivenOption> given, BroadPhase method) {
  std::erase_if(given, [](const GivenOption& option) { return option.name == "broadphase"; });
  given.push_back({"broadphase", std::string(name_of(method))});
  return given;
}

void check_views_fit(PictureSize size, size_t views) {
  const auto count = static_cast<int>(views);
  const PictureSize smallest{count * kSmallest.width, count * kSmallest.height};
  if (size.width >= smallest.width && size.height >= smallest.height) return;
  throw UserError("--size", fmt::format("{} with --compare of {} methods", text_of(size), views),
                  "at least " + text_of(smallest));
}

std::vector<Room> view_rooms(size_t count, const DomainBox& domain, float aspect, float above) {
  const auto rows_of = [&](size_t columns) { return (count + columns - 1) / columns; };
  const auto size_in = [&](size_t columns) {
    return scale_in(domain, aspect / static_cast<float>(columns), (1 - above) / static_cast<float>(rows_of(columns)));
  };
  size_t columns = count;
  for (size_t other = count - 1; other >= 1; --other) {
    if (size_in(other) < kNearly * size_in(columns)) columns = other;
  }
  const size_t rows = rows_of(columns);
  std::vector<Room> rooms;
  for (size_t k = 0; k < count; ++k) {
    const auto edge = [](size_t index, size_t all) { return static_cast<float>(index) / static_cast<float>(all); };
    const size_t column = k % columns, row = k / columns;
    const auto gap = [](bool is_inside, float line) { return is_inside ? line : 0.0f; };
    rooms.push_back({edge(column, columns) + gap(column > 0, kLine / aspect),
                     1 - edge(column + 1, columns) + gap(column + 1 < columns, kLine / aspect),
                     (1 - above) * (1 - edge(row + 1, rows)) + gap(row + 1 < rows, kLine),
                     above + (1 - above) * edge(row, rows) + kLine});
  }
  return rooms;
}

MethodSign sign_of(BroadPhase method) {
  switch (method) {
    case BroadPhase::brute_force:
    case BroadPhase::lecture_brute_force:
      return MethodSign::ring;
    case BroadPhase::sort_and_sweep:
    case BroadPhase::lecture_sort_and_sweep:
      return MethodSign::triangle;
    case BroadPhase::linked_cell:
    case BroadPhase::lecture_linked_cell:
      return MethodSign::square;
    case BroadPhase::sorted_grid:
      return MethodSign::diamond;
    case BroadPhase::automatic:
      break;
  }
  return MethodSign::none;
}

}  // namespace ballpit
