// SPDX-License-Identifier: MIT
// A sheet of glass before the picture: text, lines, boxes and arrows in pixels, sharp at any size of picture.
// Drawn by Dear ImGui's draw lists; whoever draws a panel over the picture shares the sheet's ImGui context and its fonts.
//
//     begin(width, height, …) fonts for this height of picture; what was drawn is forgotten
//     text, line, arrow, …   collected; (0, 0) is the upper left corner, y goes down
//     draw()                 onto the framebuffer that is bound, where the picture is drawn already
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "core/math.h"
#include "render/line_renderer.h"

struct ImGuiContext;
struct ImDrawList;
struct ImFont;

namespace ballpit {

/// Sizes at 1080 lines: 22, 26 and 38 pixels, and a panel's, 22 unless scaled; in proportion at others, and never below 9.
enum class TextSize { small, normal, title, panel };

/// Which point of a text, or of anything with a width and a height, a place tells: fractions of both, from the upper left.
struct Anchor {
  float x = 0, y = 0;
};
inline constexpr Anchor kUpperLeft{0, 0}, kUpperRight{1, 0}, kLowerLeft{0, 1}, kCentre{0.5f, 0.5f}, kLeft{0, 0.5f},
    kRight{1, 0.5f}, kTop{0.5f, 0}, kBottom{0.5f, 1};

class Sheet {
 public:
  /// Needs a current OpenGL context from its making to its end. Throws RunError where ImGui cannot draw there.
  Sheet();
  ~Sheet();
  Sheet(const Sheet&) = delete;
  Sheet& operator=(const Sheet&) = delete;

  /// For a picture of this size, whose first `left` pixels of width are a panel's: x counts from there.
  void begin(int width, int height, int left = 0);
  void draw();

  int width() const { return width_ - left_; }  ///< [pixel] beside a panel
  int picture_width() const { return width_; }  ///< [pixel] with it
  int height() const { return height_; }        ///< [pixel]
  int left() const { return left_; }            ///< [pixel] of the width that is a panel's
  float unit() const;                           ///< [pixel] 1/1080 of the height

  Vec2 size_of(std::string_view text, TextSize size = TextSize::normal) const;  ///< [pixel]
  void text(Vec2 at, Anchor anchor, Rgba color, std::string_view text, TextSize size = TextSize::normal);

  void line(Vec2 a, Vec2 b, Rgba color, float width);
  void dotted(Vec2 a, Vec2 b, Rgba color, float width);
  void arrow(Vec2 from, Vec2 to, Rgba color, float width);                    ///< with a head at `to`
  void curved_arrow(Vec2 from, Vec2 over, Vec2 to, Rgba color, float width);  ///< sets off and arrives as if by `over`
  void box(Vec2 low, Vec2 high, Rgba fill, float rounding = 0);
  void frame(Vec2 low, Vec2 high, Rgba color, float width, float rounding = 0);
  void disc(Vec2 centre, float radius, Rgba fill);
  void ring(Vec2 centre, float radius, Rgba color, float width);

  /// Makes a panel's text, ImGui's default, larger or smaller: `scale` times, and `density` pixels for each at the least that
  /// a display with more of them to the inch needs. Not within a frame of ImGui's.
  void scale_panel(float scale, float density = 1);

  /// For the panel: current while it is drawn.
  ImGuiContext* context() const { return context_; }
  ImFont* font(TextSize size) const { return fonts_[static_cast<size_t>(size)]; }

 private:
  void load_fonts();
  void prepare_shapes();

  ImGuiContext* context_;
  std::unique_ptr<ImDrawList> list_;
  std::array<ImFont*, 4> fonts_{};
  float panel_scale_ = 1, panel_density_ = 1;
  int width_ = 0, height_ = 0, left_ = 0, font_height_ = 0;
};

}  // namespace ballpit
