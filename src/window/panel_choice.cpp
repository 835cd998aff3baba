// SPDX-License-Identifier: MIT
// The cheapest settings that are good enough: the button that looks for them, what was chosen, and why nothing else.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "core/language.h"
#include "core/numbers.h"
#include "core/phrase.h"
#include "methods/methods.h"
#include "window/panel.h"

namespace ballpit {

namespace {

constexpr float kDiamond = 14;  // in units of the sheet

std::string number(double value) { return local_number(fmt::format("{:.2g}", value)); }

/// "energy_tolerance 0.2, allowed 0.01": the tolerance that an attempt breaks most, or all that are known.
std::string figures_of(const Attempt& attempt, const std::vector<Tolerance>& tolerances, bool has_all) {
  std::string text;
  double worst = 1;
  for (size_t k = 0; k < tolerances.size(); ++k) {
    const double allowed = tolerances[k].allowed, ratio = allowed > 0 ? attempt.errors[k] / allowed : INFINITY;
    if (!attempt.knows(k) || (!has_all && ratio <= worst)) continue;
    text = has_all && !text.empty() ? text + "; " : "";
    text += phrase("{} {}, allowed {}", tolerances[k].name, number(attempt.errors[k]), number(allowed));
    worst = ratio;
  }
  return text;
}

/// What became of an attempt, in a few words.
std::string outcome_of(const Attempt& attempt, const std::vector<Tolerance>& tolerances) {
  if (attempt.holds) return phrase("{} of computing", with_unit(attempt.cost, "s", true));
  const std::string broken = attempt.remark.empty() ? figures_of(attempt, tolerances, false) : attempt.remark;
  return broken.empty() ? phrase("too close") : broken;
}

/// The words of a text; a number and its unit are one.
std::vector<std::string> words_of(const std::string& text) {
  constexpr size_t kUnit = 4;  // bytes at most: "µs;"
  std::vector<std::string> words;
  for (const std::string& word : split_list(text, ' ')) {
    const bool follows_number =
        !words.empty() && !words.back().empty() && std::isdigit(static_cast<unsigned char>(words.back().back())) != 0;
    if (follows_number && word.size() <= kUnit && word.find_first_of("0123456789") == std::string::npos) {
      words.back() += " " + word;
    } else {
      words.push_back(word);
    }
  }
  return words;
}

/// With line breaks between words. ImGui's own also break within 0.25, after the point.
std::string wrapped(const std::string& text, float width) {
  std::string lines;
  size_t line = 0;  // where the last one begins
  for (const std::string& word : words_of(text)) {
    const std::string longer = lines.substr(line) + (lines.size() > line ? " " : "") + word;
    if (lines.size() > line && ImGui::CalcTextSize(longer.c_str()).x > width) {
      lines += '\n' + word;
      line = lines.size() - word.size();
    } else {
      lines.replace(line, std::string::npos, longer);
    }
  }
  return lines;
}

/// Of each method that was tried: the cheapest attempt that holds, else the one that came nearest. Those that hold come
/// first, by cost.
std::vector<const Attempt*> best_of_methods(const Choice& choice) {
  const auto rank = [](const Attempt* a) { return std::tuple(!a->holds, a->holds ? a->cost : a->worst); };
  std::vector<const Attempt*> best;
  for (const Attempt& attempt : choice.tried) {
    const auto same = std::ranges::find(best, attempt.method, &Attempt::method);
    if (same == best.end()) {
      best.push_back(&attempt);
    } else if (rank(&attempt) < rank(*same)) {
      *same = &attempt;
    }
  }
  std::ranges::stable_sort(best, {}, rank);
  return best;
}

/// Methods and what is said of them. Those of which the same is said share a line.
class Lines {
 public:
  void add(const std::string& method, const std::string& said) {
    const auto same = std::ranges::find(lines_, said, &std::pair<std::string, std::string>::second);
    if (same == lines_.end()) {
      lines_.emplace_back(method, said);
    } else {
      same->first += "; " + method;
    }
  }
  auto begin() const { return lines_.begin(); }
  auto end() const { return lines_.end(); }

 private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

}  // namespace

/// A text of as many lines as it takes.
void Panel::paragraph(const std::string& name, const std::string& text) {
  ImGui::TextUnformatted(wrapped(text, ImGui::GetContentRegionAvail().x).c_str());
  note(name);
}

void Panel::draw_choice(Demo& demo) {
  ImGui::Spacing();
  const std::string label = demo.is_choosing() ? "choosing…" : std::string(find_method(Response::automatic).label);
  if (button("cheapest", translated(label))) demo.choose_cheapest();
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s", translated("tries all methods on copies of the scene; press again to stop").c_str());
  }
  const Choice* const choice = demo.choice();
  if (choice == nullptr) return;
  paragraph("choice", choice->reason);
  const bool is_open = ImGui::TreeNodeEx((translated("why") + "##why").c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
  note("why");
  if (!is_open) return;
  draw_reasons(*choice);
  ImGui::TreePop();
}

/// What is below "why".
void Panel::draw_reasons(const Choice& choice) {
  const auto title = [](const char* text) { ImGui::TextDisabled("%s", translated(text).c_str()); };
  if (!choice.needs.note.empty()) paragraph("needs", choice.needs.note);
  if (!choice.chosen && choice.nearest) {
    title("nearest");
    paragraph("nearest", choice.nearest->method + ": " + figures_of(*choice.nearest, choice.tolerances, true));
  }
  Lines ruled_out, tried;
  for (const RuledOut& out : choice.ruled_out) ruled_out.add(out.method, out.reason);
  for (const Attempt* best : best_of_methods(choice)) tried.add(best->method, outcome_of(*best, choice.tolerances));
  if (!choice.ruled_out.empty()) title("ruled out");
  for (const auto& [methods, reason] : ruled_out) paragraph("ruled out " + methods, methods + ": " + reason);
  if (!choice.tried.empty()) title("tried");
  for (const auto& [methods, outcome] : tried) paragraph("tried " + methods, methods + ": " + outcome);
  if (choice.is_out_of_time) paragraph("out of time", translated("the time ran out before all was tried"));
  if (choice.unneeded.empty()) return;
  title("not needed");
  paragraph("not needed", join(choice.unneeded, "; "));
}

/// A diamond for the settings of the choice, which nobody has played yet, and its meaning below the chart.
void Panel::draw_prediction(Vec2 at, Vec2 legend) {
  ImDrawList& lines = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text), fill = ImGui::GetColorU32(ImGuiCol_CheckMark);
  const auto diamond = [&](Vec2 p, float radius) {
    const ImVec2 corners[]{{p.x, p.y - radius}, {p.x + radius, p.y}, {p.x, p.y + radius}, {p.x - radius, p.y}};
    lines.AddQuadFilled(corners[0], corners[1], corners[2], corners[3], fill);
    lines.AddQuad(corners[0], corners[1], corners[2], corners[3], ink, 2 * sheet_.unit());
  };
  const float unit = sheet_.unit(), text = ImGui::GetTextLineHeight();
  const Vec2 corner(kDiamond * unit);
  diamond(at, corner.x);  // a trial has room in it
  items_["prediction"] = {at - corner, at + corner};
  diamond({legend.x + 0.5f * text, legend.y + 0.5f * text}, 0.4f * text);
  lines.AddText({legend.x + 1.4f * text, legend.y}, ink, translated("what the choice expects").c_str());
}

}  // namespace ballpit
