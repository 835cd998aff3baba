// SPDX-License-Identifier: MIT
#include "render/painter.h"

#include "core/language.h"

namespace ballpit {

namespace {

constexpr float kNoteMargin = 16, kNotePad = 8, kSample = 40;  // [1/1080 of the picture's height]

/// Draws the sample from `at` to the right.
void draw_swatch(Sheet& sheet, const NotePart& part, Vec2 at) {
  const float u = sheet.unit();
  const Rgba color = to_rgba(part.color);
  const Vec2 end = at + Vec2(kSample * u, 0), gap(0, 5 * u);
  switch (part.swatch) {
    case Swatch::none:
      break;
    case Swatch::line:
      sheet.line(at, end, to_rgba(rim_of(part.color)), 7 * u);
      sheet.line(at, end, color, 4 * u);
      break;
    case Swatch::bold:
      sheet.line(at, end, color, 15 * u);
      sheet.line(at, end, to_rgba(rim_of(part.color)), 7 * u);
      break;
    case Swatch::arrow:
      sheet.arrow(at, end, color, 4 * u);
      break;
    case Swatch::square:
      sheet.box(at + Vec2(8, -12) * u, at + Vec2(32, 12) * u, color);
      break;
    case Swatch::pale:
      sheet.box(at + Vec2(8, -12) * u, at + Vec2(32, 12) * u, to_rgba(part.color, kPale));
      sheet.frame(at + Vec2(8, -12) * u, at + Vec2(32, 12) * u, color, 1.5f * u);
      break;
    case Swatch::stub:
      sheet.line(at + Vec2(20, -12) * u, at + Vec2(20, 8) * u, color, 3 * u);
      sheet.line(at + Vec2(10, 8) * u, at + Vec2(30, 8) * u, color, 3 * u);
      break;
    case Swatch::twice:
      sheet.line(at - gap, end - gap, color, 4 * u);
      sheet.line(at + gap, end + gap, color, 4 * u);
      break;
  }
}

/// Sentences without samples that are wider than `width` become several notes.
std::vector<std::vector<NotePart>> in_lines(const std::vector<std::vector<NotePart>>& notes, const Sheet& sheet,
                                            float width) {
  std::vector<std::vector<NotePart>> lines;
  for (const std::vector<NotePart>& parts : notes) {
    if (parts.size() == 1 && parts.front().swatch == Swatch::none) {
      for (const std::string& line : wrap_text(sheet, parts.front().text, width, TextSize::small)) {
        lines.push_back({{Swatch::none, {}, line}});
      }
    } else {
      lines.push_back(parts);
    }
  }
  return lines;
}

}  // namespace

void Painter::note(const std::string& text) {
  const float width = static_cast<float>(sheet.width()) - note_left - 2 * kNoteMargin * sheet.unit();
  for (const std::string& line : wrap_text(sheet, translated(text), width, TextSize::small)) {
    note({{Swatch::none, {}, line}});
  }
}

void Painter::draw_notes() {
  constexpr TextSize kSize = TextSize::small;
  const float u = sheet.unit(), height = sheet.size_of("0", kSize).y + kNotePad * u / 2;
  const float sample = (kSample + kNotePad) * u, space = 2.5f * kNotePad * u;
  const auto width_of = [&](const NotePart& part) {
    return sheet.size_of(part.text, kSize).x + space + (part.swatch == Swatch::none ? 0 : sample);
  };
  const float left = kNoteMargin * u + note_left;
  float y = kNoteMargin * u + noted + note_skip;
  for (const std::vector<NotePart>& parts : wraps_sentences ? in_lines(notes, sheet, note_width) : notes) {
    for (size_t first = 0, end = 0; first < parts.size(); first = end) {  // the lines of a note
      float width = 0;
      while (end < parts.size() && (end == first || note_width <= 0 || width + width_of(parts[end]) <= note_width)) {
        width += width_of(parts[end++]);
      }
      sheet.box({left - kNotePad * u, y}, {left + width - space + kNotePad * u, y + height}, ground());
      cover({left - kNotePad * u, y}, {left + width - space + kNotePad * u, y + height});
      Vec2 at(left, y + height / 2);
      for (size_t k = first; k < end; ++k) {
        const bool has_sample = parts[k].swatch != Swatch::none;
        if (has_sample) draw_swatch(sheet, parts[k], at);
        sheet.text(at + Vec2(has_sample ? sample : 0, 0), kLeft, ink(), parts[k].text, kSize);
        at.x += width_of(parts[k]);
      }
      y += height;
    }
  }
  notes.clear();
}

void Painter::draw_rimmed(const std::vector<Line>& lines_, const Vec3& rim_color, float width, float rim) {
  std::vector<Line> rims = lines_;
  const Rgba color = to_rgba(rim_color) & 0xFFFFFFu;
  for (Line& line : rims) {
    for (Rgba* end : {&line.color_a, &line.color_b}) *end = color | (*end & 0xFF000000u);
  }
  lines.draw(rims, (width + 2 * rim) * line_unit);
  lines.draw(lines_, width * line_unit);
}

void Painter::draw_shining(const std::vector<Line>& lines_, const Vec3& rim_color, float width, float rim) {
  constexpr Rgba kFaint = 0x73000000u;  // 45 %
  std::vector<Line> faint = lines_;
  for (Line& line : faint) {
    for (Rgba* end : {&line.color_a, &line.color_b})
      *end = std::min(*end >> 24, kFaint >> 24) << 24 | (*end & 0xFFFFFFu);
  }
  glDepthFunc(GL_GREATER);
  draw_rimmed(faint, rim_color, width, rim);
  glDepthFunc(GL_LEQUAL);
  draw_rimmed(lines_, rim_color, width, rim);
}

float Painter::take_strip(float height) {
  const float bottom = static_cast<float>(sheet.height()) - taken;
  taken += height;
  sheet.box({0, bottom - height}, {static_cast<float>(sheet.width()), bottom}, to_rgba(theme.background));
  return bottom - height;
}

std::vector<std::string> wrap_text(const Sheet& sheet, const std::string& text, float width, TextSize size) {
  std::vector<std::string> lines{""};
  size_t start = 0;
  while (start < text.size()) {
    const size_t end = std::min(text.find(' ', start), text.size());
    const std::string word = text.substr(start, end - start);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (!lines.back().empty() && sheet.size_of(longer, size).x > width) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
    start = end + 1;
  }
  return lines;
}

std::string counted(int64_t number, const std::string& noun) {
  return grouped(number) + " " + translated(noun + (number == 1 ? "" : "s"));
}

}  // namespace ballpit
