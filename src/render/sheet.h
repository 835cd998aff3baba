// SPDX-License-Identifier: MIT
// A transparent layer in front of the picture: text, lines, boxes and arrows in pixels, sharp at any size of picture.
// Drawn by Dear ImGui's draw lists; a panel over the picture shares the sheet's ImGui context and its fonts.
//
//     begin(width, height, …)   clears the sheet, loads fonts for this height of picture
//     text, line, arrow, …      are collected; (0, 0) is the upper left corner, y goes down
//     draw()                    draws them over the picture in the bound framebuffer
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "render/shapes.h"

struct ImGuiContext;
struct ImDrawList;
struct ImFont;

namespace ballpit {

/// At 1080 lines: 36, 40 and 48 pixels, 22 for the panel, and 34 for code, whose letters have equal widths; in
/// proportion at other heights, at least 9. Digits and capitals are 0.6 times as high. Panel and scene have scales of
/// their own: with 1.6, that of a lecture, the sizes are 45, 58 and 60. Captions grow most: numbers must still fit into
/// boxes and cells.
enum class TextSize { small, normal, title, panel, code };

/// [1/1080 of the picture's height] of a line of the scene's text at this scale.
float line_height(TextSize size, float text_scale);

/// The point of a text that a position refers to: fractions of its width and height, from the upper left.
struct Anchor {
  float x = 0, y = 0;
};
inline constexpr Anchor kUpperLeft{0, 0}, kUpperRight{1, 0}, kLowerLeft{0, 1}, kCentre{0.5f, 0.5f}, kLeft{0, 0.5f},
    kTop{0.5f, 0}, kBottom{0.5f, 1};

/// A part of a picture [pixel]; `left` and `top` are measured from its upper left corner.
struct PictureRect {
  int left, top, width, height;
};

class Sheet {
 public:
  /// Needs a current OpenGL context for its whole life. Throws RunError if ImGui cannot draw in it.
  Sheet();
  ~Sheet();
  Sheet(const Sheet&) = delete;
  Sheet& operator=(const Sheet&) = delete;

  /// For a part of a picture of this size, without its panel and other views: x and y start there. `scale` is that of
  /// the scene's text.
  void begin(int width, int height, const PictureRect& part, float scale = 1);
  void draw();

  int width() const { return part_.width; }       ///< [pixel] of the part
  int height() const { return part_.height; }     ///< [pixel] of the part
  int picture_width() const { return width_; }    ///< [pixel]
  int picture_height() const { return height_; }  ///< [pixel]
  float unit() const;                             ///< [pixel] 1/1080 of the picture's height

  Vec2 size_of(std::string_view text, TextSize size = TextSize::normal) const;  ///< [pixel]
  void text(Vec2 at, Anchor anchor, Rgba color, std::string_view text, TextSize size = TextSize::normal,
            float scale = 1);
  /// With a border in another colour, so that it is legible over anything.
  void bordered_text(Vec2 at, Anchor anchor, Rgba color, Rgba border, std::string_view text, TextSize size);

  void line(Vec2 a, Vec2 b, Rgba color, float width);
  void dotted(Vec2 a, Vec2 b, Rgba color, float width);
  void arrow(Vec2 from, Vec2 to, Rgba color, float width);  ///< with a head at `to`
  void curved_arrow(Vec2 from, Vec2 over, Vec2 to, Rgba color,
                    float width);  ///< starts and arrives in the direction of `over`
  void triangle(Vec2 a, Vec2 b, Vec2 c, Rgba fill);
  void box(Vec2 low, Vec2 high, Rgba fill, float rounding = 0);
  void frame(Vec2 low, Vec2 high, Rgba color, float width, float rounding = 0);
  void disc(Vec2 centre, float radius, Rgba fill);
  void ring(Vec2 centre, float radius, Rgba color, float width);

  /// Scales the panel's text, ImGui's default. `density`: pixels per unit of length on this display, relative to an
  /// ordinary one; it raises the smallest size. Do not call within a frame of ImGui.
  void scale_panel(float scale, float density = 1);

  /// For the panel: the context that must be current while it is drawn.
  ImGuiContext* context() const { return context_; }
  ImFont* font(TextSize size) const { return fonts_[static_cast<size_t>(size)]; }
  float text_scale() const { return text_scale_; }

 private:
  void load_fonts();
  void prepare_shapes();

  ImGuiContext* context_;
  std::unique_ptr<ImDrawList> list_;
  std::array<ImFont*, 5> fonts_{};
  float panel_scale_ = 1, panel_density_ = 1, text_scale_ = 1;
  int width_ = 0, height_ = 0, font_height_ = 0;  // of the picture
  PictureRect part_{};
};

}  // namespace ballpit
