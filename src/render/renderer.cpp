// SPDX-License-Identifier: MIT
#include "render/renderer.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/error.h"
#include "render/domain_box.h"
#include "render/gl_debug.h"
#include "render/overlays/overlay.h"

namespace ballpit {

namespace {

/// Where to draw a picture that is averaged afterwards; none if it is drawn as it is.
std::optional<RenderTarget> large_target(const RenderTarget& picture, int supersample) {
  if (supersample < 1 || supersample > 4) throw UserError("--supersample", std::to_string(supersample), "1 to 4");
  if (supersample == 1) return std::nullopt;
  return RenderTarget(picture.width() * supersample, picture.height() * supersample);
}

void draw_overlays(const FrameView& view, Painter& painter, bool before_bodies) {
  for (const OverlayEntry& entry : overlay_table()) {
    if (std::find(view.overlays.begin(), view.overlays.end(), entry.name) == view.overlays.end()) continue;
    const std::string lack = before_bodies ? "" : entry.lack(view.inspection);
    if (!lack.empty()) painter.note(std::string(entry.label) + ": " + lack);
    if (before_bodies == (entry.is_under_discs && view.domain.is_planar())) entry.draw(view, painter);
  }
}

}  // namespace

Renderer::Renderer(int width, int height, const RenderOptions& options)
    : options_(options), picture_(width, height), large_(large_target(picture_, options.supersample)) {
  sheet_.begin(width, height, options.left);
  check_gl("preparing to draw");
}

void Renderer::set_options(const RenderOptions& options) {
  if (options.supersample != options_.supersample) large_ = large_target(picture_, options.supersample);
  options_ = options;
}

void Renderer::resize(int width, int height) {
  RenderTarget picture(width, height);
  large_ = large_target(picture, options_.supersample);
  picture_ = std::move(picture);
}

void Renderer::draw(const FrameView& view) {
  if (!view.is_written) bodies_.upload(view.inspection.bodies);
  const ColoringEntry& coloring = coloring_named(view.coloring);
  Colored colored;
  if (!view.is_written || coloring.wanted.state) {
    colored = coloring.color(view.inspection);
    bodies_.set_marks(colored.marks);
  }
  sheet_.begin(width(), height(), options_.left);
  canvas().bind();
  set_state();
  const int left = options_.left * options_.supersample;
  glViewport(left, 0, canvas().width() - left, canvas().height());
  uniforms_.set(view, options_.theme, canvas().width() - left, canvas().height());
  draw_scene(view, coloring, colored);
  if (large_) average();
  picture_.bind();
  sheet_.draw();
  check_gl("drawing a frame");
}

void Renderer::set_state() {
  const Vec3& ground = options_.theme.background;
  glClearColor(ground.r, ground.g, ground.b, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glEnable(GL_BLEND);
  // The picture stays opaque: blending keeps the alpha of the cleared picture.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
}

void Renderer::draw_scene(const FrameView& view, const ColoringEntry& coloring, const Colored& colored) {
  const int height = canvas().height();
  Painter painter{lines_, faces_, sheet_, options_.theme, static_cast<float>(height) / 1080.0f, {}, {}};
  draw_floor(view.domain, painter);
  draw_overlays(view, painter, true);
  body_renderer_.draw(bodies_, view, height);
  draw_overlays(view, painter, false);
  draw_edges(view.domain, painter);
  draw_legend(coloring, colored, painter);
}

/// Draws the large picture into the one of final size.
void Renderer::average() {
  picture_.bind();
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  average_.set("per_side", options_.supersample);
  average_.use();
  glBindTextureUnit(0, large_->color());
  glBindVertexArray(no_attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Image Renderer::read_pixels() {
  Image image{width(), height(), {}};
  const size_t row = static_cast<size_t>(image.width) * 4;
  image.pixels.resize(row * static_cast<size_t>(image.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_.framebuffer());
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  check_gl("reading a frame");
  for (int y = 0; y < image.height / 2; ++y) {  // OpenGL's rows go from bottom to top
    uint8_t* upper = image.pixels.data() + static_cast<size_t>(y) * row;
    uint8_t* lower = image.pixels.data() + static_cast<size_t>(image.height - 1 - y) * row;
    std::swap_ranges(upper, upper + row, lower);
  }
  return image;
}

void Renderer::copy_to_window() {
  const int w = width(), h = height();
  glBlitNamedFramebuffer(picture_.framebuffer(), 0, 0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  check_gl("showing a frame");
}

}  // namespace ballpit
