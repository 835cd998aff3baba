// SPDX-License-Identifier: MIT
// What overlays draw with. It assigns two areas of the picture, so that overlays do not cover each other:
//
//     ┌──────────────────────────┐
//     │ ─ 12 apart  ━ 3 contacts │   note(): lines of a legend, downwards
//     │ → longest arrow: 2.3 m/s │
//     │                          │
//     │▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒│   take_strip(): full width, upwards
//     └──────────────────────────┘
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "core/language.h"
#include "core/numbers.h"
#include "render/body_buffer.h"
#include "render/frame_view.h"
#include "render/sheet.h"
#include "render/theme.h"

namespace ballpit {

/// A sample in the legend of how something looks in the picture.
enum class Swatch { none, line, bold, twice, arrow, square, pale, stub };

inline constexpr float kPale = 0.25f;  ///< opacity of a pale area in a frame of its colour

struct NotePart {
  Swatch swatch;
  Vec3 color;
  std::string text;
};

/// From its upper left to its lower right corner [pixel].
struct PixelRect {
  Vec2 low, high;
};

struct Painter {
  LineRenderer& lines;
  FaceRenderer& faces;
  Sheet& sheet;  ///< in pixels, in front of everything that is drawn in space
  const Theme& theme;
  float line_unit;               ///< [pixel] 1/1080 of the picture's height, so that lines look the same at every size
  float noted = 0;               ///< [pixel] where the notes begin: their upper edge
  float note_left = 0;           ///< [pixel] their left edge
  float note_width = 0;          ///< [pixel] a longer note continues in the next line; 0: none does
  bool wraps_sentences = false;  ///< whether notes without samples do so at blanks
  float note_skip = 0;           ///< [pixel] the notes begin so much lower, below a legend
  float taken = 0;               ///< [pixel] height of the strips so far
  const std::vector<Mark>* marks = nullptr;  ///< of the bodies, where a colouring has set them
  std::vector<std::vector<NotePart>> notes{};
  std::vector<PixelRect> covered{};  ///< by notes and legend

  /// Adds a line to the legend in the upper left corner. All are drawn at last, in front of everything.
  void note(std::vector<NotePart> parts) { notes.push_back(std::move(parts)); }
  void note(const std::string& text);
  void draw_notes();
  void cover(Vec2 low, Vec2 high) { covered.push_back({low, high}); }

  /// Draws lines with a rim on both sides, which keeps them visible on spheres and on either ground. `width` and `rim`
  /// in 1/1080 of the picture's height.
  void draw_rimmed(const std::vector<Line>& lines, const Vec3& rim_color, float width, float rim);

  /// The same for lines that are the subject: where something hides them, they shine through it, fainter.
  void draw_shining(const std::vector<Line>& lines, const Vec3& rim_color, float width, float rim);

  /// Takes a strip at the lower edge, over the whole width, and gives it a translucent ground. Returns its top [pixel].
  float take_strip(float height);

  Rgba ink(float opacity = 1) const { return to_rgba(theme.text, opacity); }
  Rgba ground() const { return to_rgba(theme.background, 0.85f); }
};

/// Computes the pixel of a point in space, for drawing on the sheet.
class Projection {
 public:
  Projection(const Camera& camera, const Sheet& sheet)
      : camera_(camera),
        view_(camera.view()),
        clip_(camera.projection() * view_),
        size_(sheet.width(), sheet.height()) {}

  /// [m] Distance from the plane of the eye.
  float depth(const Vec3& point) const { return -(view_ * Vec4(point, 1)).z; }

  bool sees(const Vec3& point) const { return depth(point) > camera_.near; }

  /// [pixel] from the upper left corner; y goes down. Only for points that sees() accepts.
  Vec2 at(const Vec3& point) const {
    const Vec4 clip = clip_ * Vec4(point, 1);
    return Vec2(1 + clip.x / clip.w, 1 - clip.y / clip.w) / 2.0f * size_;
  }

  /// [pixel] of a length [m] at a point, perpendicular to the view.
  float length_at(const Vec3& point, float length) const {
    return length / camera_.pixel_size(depth(point), static_cast<int>(size_.y));
  }

  /// A point at the same pixel, but nearer by `distance`: a point inside a sphere moves in front of that sphere, but
  /// stays behind other spheres that hide it.
  Vec3 lift(const Vec3& point, float distance) const {
    const Vec3 towards_eye = camera_.is_orthographic() ? camera_.eye - camera_.target : camera_.eye - point;
    return point + distance * normalize(towards_eye);
  }

 private:
  Camera camera_;
  Mat4 view_, clip_;
  Vec2 size_;
};

/// Makes lines of overlays thinner where spheres are small, so that the lines do not hide the spheres.
/// A factor for widths: 1, or less if the mean sphere is small in the picture. `unit`: 1/1080 of its height [pixel].
inline float line_scale(const FrameView& view, const Projection& projection, float unit) {
  constexpr float kFull = 24, kMin = 0.25f;  // the radius [unit] from which the factor is 1; the smallest factor
  const std::vector<float>& radius = view.inspection.bodies.radius;
  const Vec3 middle = (view.domain.min + view.domain.max) / 2.0f;
  if (radius.empty() || !projection.sees(middle)) return 1;
  const float mean = std::accumulate(radius.begin(), radius.end(), 0.0f) / static_cast<float>(radius.size());
  return std::clamp(projection.length_at(middle, mean) / (kFull * unit), kMin, 1.0f);
}

/// How visible lines in a box are, by their depth: from 1 at the front of the box to a quarter at its back.
inline float fade_at(const Vec3& point, const Vec3& min, const Vec3& max, const Camera& camera) {
  constexpr float kFarthest = 0.25f;
  const float middle = length((min + max) / 2.0f - camera.eye), reach = length(max - min) / 2;
  const float way = (length(point - camera.eye) - (middle - reach)) / (2 * reach);
  return 1 + (kFarthest - 1) * std::clamp(way, 0.0f, 1.0f);
}

/// The text in lines of at most `width` pixels, broken at blanks.
std::vector<std::string> wrap_text(const Sheet& sheet, const std::string& text, float width, TextSize size);

/// (1, "contact") → "1 contact"; (1200, "contact") → "1 200 contacts".
std::string counted(int64_t number, const std::string& noun);

}  // namespace ballpit
