// SPDX-License-Identifier: MIT
#include "render/painter.h"

namespace ballpit {

namespace {

constexpr float kMargin = 16, kPad = 8, kSample = 40;  // [1/1080 of the picture's height]

/// Draws the sample from `at` to the right.
void draw_swatch(Sheet& sheet, const NotePart& part, Vec2 at) {
  const float u = sheet.unit();
  const Rgba color = to_rgba(part.color);
  const Vec2 end = at + Vec2(kSample * u, 0), gap(0, 5 * u);
  switch (part.swatch) {
    case Swatch::none:
      break;
    case Swatch::line:
      sheet.line(at, end, color, 3 * u);
      break;
    case Swatch::bold:
      sheet.line(at, end, color, 15 * u);
      sheet.line(at, end, to_rgba(0.45f * part.color), 7 * u);
      break;
    case Swatch::arrow:
      sheet.arrow(at, end, color, 4 * u);
      break;
    case Swatch::square:
      sheet.box(at + Vec2(8, -12) * u, at + Vec2(32, 12) * u, color);
      break;
    case Swatch::twice:
      sheet.line(at - gap, end - gap, color, 4 * u);
      sheet.line(at + gap, end + gap, color, 4 * u);
      break;
  }
}

}  // namespace

void Painter::note(const std::vector<NotePart>& parts) {
  const float u = sheet.unit(), height = sheet.size_of("0").y + kPad * u;
  const float sample = (kSample + kPad) * u, space = 2.5f * kPad * u;
  float width = 0;
  for (const NotePart& part : parts) {
    width += sheet.size_of(part.text).x + space + (part.swatch == Swatch::none ? 0 : sample);
  }
  Vec2 at(kMargin * u + note_left, kMargin * u + noted + height / 2);
  sheet.box(at - Vec2(kPad * u, height / 2), at + Vec2(width - space + kPad * u, height / 2), ground());
  for (const NotePart& part : parts) {
    if (part.swatch != Swatch::none) {
      draw_swatch(sheet, part, at);
      at.x += sample;
    }
    sheet.text(at, kLeft, ink(), part.text);
    at.x += sheet.size_of(part.text).x + space;
  }
  noted += height;
}

float Painter::take_strip(float height) {
  const float bottom = static_cast<float>(sheet.height()) - taken;
  taken += height;
  sheet.box({0, bottom - height}, {static_cast<float>(sheet.width()), bottom}, ground());
  return bottom - height;
}

std::string counted(int64_t number, const std::string& noun) {
  return grouped(number) + " " + noun + (number == 1 ? "" : "s");
}

}  // namespace ballpit
