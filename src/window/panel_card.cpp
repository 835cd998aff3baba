// SPDX-License-Identifier: MIT
// The card of the picked sphere, in a corner of the scene: where it is, and what the method stores of it.
#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "core/numbers.h"
#include "core/phrase.h"
#include "render/overlays/overlay.h"
#include "window/panel.h"

namespace ballpit {

namespace {

/// "4, 7, 9"; only the first of many.
std::string numbers(const std::vector<int32_t>& bodies, const char* separator = ", ") {
  constexpr size_t kMax = 12;
  const auto end = bodies.begin() + static_cast<std::ptrdiff_t>(std::min(bodies.size(), kMax));
  const std::string text = fmt::format("{}", fmt::join(bodies.begin(), end, separator));
  return bodies.size() > kMax ? fmt::format("{}{}…", text, separator) : text;
}

/// "3: 4, 7, 9".
std::string counted_numbers(const std::vector<int32_t>& bodies) {
  if (bodies.empty()) return translated("none");
  return fmt::format("{}: {}", grouped(static_cast<int64_t>(bodies.size())), numbers(bodies));
}

/// "0.250": with millimetres in a domain of about a metre, with four digits in much smaller or larger ones.
std::string length_text(const Domain& domain, float length) {
  const Vec3d size = domain.max - domain.min;
  const double longest = std::max({size.x, size.y, size.z});
  return local_number(longest >= 0.1 && longest < 1e4 ? fmt::format("{:.3f}", length) : fmt::format("{:.4g}", length));
}

/// Whether the body is drawn in the right half of the upper half of the scene, where the card is else.
bool is_upper_right(const FrameView& view, int32_t body) {
  const Vec4 clip = view.camera.projection() * view.camera.view() * Vec4(view.inspection.bodies.position_of(body), 1);
  return clip.x > 0 && clip.y > 0;
}

}  // namespace

void Panel::draw_card(Demo& demo) {
  const auto i = static_cast<int32_t>(demo.view.selected);
  if (i < 0) return;
  const Inspection& inspection = demo.inspection();
  if (i >= inspection.bodies.count) return;
  const float beside = static_cast<float>(
                  width_beside(*this, {sheet_.picture_width(), sheet_.picture_height()}, demo.view.ui_scale)),
              width = static_cast<float>(sheet_.picture_width()), margin = 12 * sheet_.unit(),
              high = std::max(margin, top * static_cast<float>(sheet_.picture_height()));
  const FrameView view = demo.frame_view((width - beside) / static_cast<float>(sheet_.picture_height()));
  if (is_upper_right(view, i)) {
    ImGui::SetNextWindowPos({beside + margin, high});
  } else {
    ImGui::SetNextWindowPos({width - margin, high}, ImGuiCond_Always, {1, 0});
  }
  ImGui::SetNextWindowSize({std::min(22 * ImGui::GetFontSize(), 0.5f * (width - beside)), 0});
  ImGui::Begin("card", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  items_["card"] = {{low.x, low.y}, {low.x + size.x, low.y + size.y}};
  const Vec3 p = inspection.bodies.position_of(i);
  const auto metres = [&](float length) { return length_text(demo.session.scene().domain, length); };
  const char* const separator = language() == Language::german ? "; " : ", ";  // numbers have commas there
  std::string place = metres(p.x) + separator + metres(p.y);
  if (inspection.bodies.dimensions == 3) place += separator + metres(p.z);
  row("sphere", std::to_string(i));
  row("place", place + " m");
  row("speed", with_unit(double(length(inspection.bodies.velocity_of(i))), "m/s"));
  row("touches", counted_numbers(touching(inspection, i)));
  if (const std::vector<int32_t> missed = partners_of(inspection.missed, i); !missed.empty()) {
    row("missed", counted_numbers(missed));
  }
  draw_places(inspection, i);
  const std::vector<Endpoint>& ends = inspection.endpoints;
  if (const Walk walk = shown_walk(ends, i); walk.body >= 0) {
    const char axis = "xyz"[std::clamp(inspection.axis, 0, 2)];
    row("interval", phrase("{}: {} to {} m", axis, metres(ends[walk.first].at), metres(ends[walk.last].at)));
    const auto number = [](size_t k) { return grouped(static_cast<int64_t>(k)); };
    row("in the sorted list",
        phrase("entries {} and {} of {}", number(walk.first), number(walk.last), number(ends.size())));
  }
  if (!demo.has_candidates()) {
    row("candidates", translated("too many pairs to look through"));
  } else {
    row("candidates", counted_numbers(partners_of(inspection.candidates, i)));
  }
  ImGui::End();
}

/// The cell whose list or range holds the sphere.
void Panel::draw_places(const Inspection& inspection, int32_t body) {
  if (const auto listed = listed_in(inspection, body)) {
    const IVec3& c = listed->cell;
    const std::string z = inspection.bodies.dimensions == 3 ? fmt::format(", {}", c.z) : "";
    row("cell", phrase("{} at ({}, {}{})", listed->index, c.x, c.y, z));
    row(listed->is_sorted ? "its range" : "its list", numbers(listed->bodies, listed->is_sorted ? ", " : " > "));
    row("place in it", phrase("{} of {}", listed->place + 1, listed->bodies.size()));
  }
}

}  // namespace ballpit
