// SPDX-License-Identifier: MIT
#include "render/renderer.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "core/error.h"
#include "render/coloring.h"
#include "render/disc_renderer.h"
#include "render/domain_box.h"
#include "render/frame_uniforms.h"
#include "render/gl_debug.h"
#include "render/overlays/overlay.h"
#include "render/painter.h"
#include "render/render_target.h"
#include "render/sphere_renderer.h"

namespace ballpit {

namespace {

void check_supersample(int supersample) {
  if (supersample >= 1 && supersample <= 4) return;
  throw UserError("--supersample", std::to_string(supersample), "1 to 4");
}

/// Where to draw a picture that is averaged afterwards; none if it is drawn as it is.
std::optional<RenderTarget> large_target(const RenderTarget& picture, int supersample) {
  if (supersample == 1) return std::nullopt;
  return RenderTarget(picture.width() * supersample, picture.height() * supersample);
}

/// Draws `from`, which is `per_side` times larger each way, into `to`.
class Averager {
 public:
  Averager() : shader_("average.vert", "average.frag") {}

  void draw(const RenderTarget& from, const RenderTarget& to, int per_side) {
    to.bind();
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    shader_.set("per_side", per_side);
    shader_.use();
    glBindTextureUnit(0, from.color());
    glBindVertexArray(no_attributes_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

 private:
  Shader shader_;
  GlVertexArray no_attributes_;
};

}  // namespace

class Renderer::Impl {
 public:
  Impl(int width, int height, const RenderOptions& options) : options_(options), picture_(width, height) {
    sheet_.begin(width, height, options.left);
    for (const OverlayEntry& entry : overlay_table()) overlays_.push_back(entry.create());
    set_options(options);
    check_gl("preparing to draw");
  }

  void set_options(const RenderOptions& options) {
    check_supersample(options.supersample);
    if (options.supersample != options_.supersample || !large_) large_ = large_target(picture_, options.supersample);
    options_ = options;
  }

  void resize(int width, int height) {
    RenderTarget picture(width, height);
    large_ = large_target(picture, options_.supersample);
    picture_ = std::move(picture);
  }

  void draw(const FrameView& view) {
    if (!view.is_written) bodies_.upload(view.inspection.bodies);
    const ColoringEntry& coloring = coloring_named(view.coloring);
    Colored colored;
    if (!view.is_written || coloring.wanted.state) {
      colored = coloring.color(view.inspection);
      bodies_.set_marks(colored.marks);
    }
    sheet_.begin(picture_.width(), picture_.height(), options_.left);
    canvas().bind();
    set_state();
    const int left = options_.left * options_.supersample;
    glViewport(left, 0, canvas().width() - left, canvas().height());
    uniforms_.set(frame_uniforms(view, options_.theme, canvas().width() - left, canvas().height()));
    draw_scene(view, coloring, colored);
    if (large_) averager_.draw(*large_, picture_, options_.supersample);
    picture_.bind();
    sheet_.draw();
    check_gl("drawing a frame");
  }

  Image read_pixels();
  void copy_to_window();

  RenderOptions options_;
  RenderTarget picture_;
  Sheet sheet_;
  BodyBuffer bodies_;

 private:
  const RenderTarget& canvas() const { return large_ ? *large_ : picture_; }

  void set_state() {
    const Vec3& ground = options_.theme.background;
    glClearColor(ground.r, ground.g, ground.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_BLEND);
    // The picture stays opaque: alpha is kept as it was cleared.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  }

  void draw_overlays(const FrameView& view, Painter& painter, Layer layer) {
    for (size_t i = 0; i < overlays_.size(); ++i) {
      const OverlayEntry& entry = overlay_table()[i];
      if (std::find(view.overlays.begin(), view.overlays.end(), entry.name) == view.overlays.end()) continue;
      const std::string lack = layer == Layer::over ? entry.lack(view.inspection) : "";
      if (!lack.empty()) painter.note({{Swatch::none, {}, std::string(entry.label) + ": " + lack}});
      overlays_[i]->draw(view, painter, layer);
    }
  }

  void draw_scene(const FrameView& view, const ColoringEntry& coloring, const Colored& colored) {
    const int height = canvas().height();
    Painter painter{lines_, faces_, sheet_, options_.theme, static_cast<float>(height) / 1080.0f, {}, {}};
    draw_floor(view.domain, painter);
    draw_overlays(view, painter, Layer::under);
    if (view.domain.is_planar()) {
      discs_.draw(bodies_);
    } else {
      if (!all_are_points(bodies_, view, height)) spheres_.draw_shadows(bodies_);
      spheres_.draw(bodies_, view, height);
    }
    draw_overlays(view, painter, Layer::over);
    draw_edges(view.domain, painter);
    draw_legend(coloring, colored, painter);
  }

  std::optional<RenderTarget> large_;  ///< where supersampled pictures are drawn
  FrameUniformBuffer uniforms_;
  SphereRenderer spheres_;
  DiscRenderer discs_;
  LineRenderer lines_;
  FaceRenderer faces_;
  Averager averager_;
  std::vector<std::unique_ptr<Overlay>> overlays_;  ///< in the table's order
};

Image Renderer::Impl::read_pixels() {
  Image image;
  image.width = picture_.width();
  image.height = picture_.height();
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

void Renderer::Impl::copy_to_window() {
  const int w = picture_.width();
  const int h = picture_.height();
  glBlitNamedFramebuffer(picture_.framebuffer(), 0, 0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  check_gl("showing a frame");
}

Renderer::Renderer(int width, int height, const RenderOptions& options)
    : impl_(std::make_unique<Impl>(width, height, options)) {}
Renderer::~Renderer() = default;
void Renderer::draw(const FrameView& view) { impl_->draw(view); }
Image Renderer::read_pixels() { return impl_->read_pixels(); }
void Renderer::copy_to_window() { impl_->copy_to_window(); }
int Renderer::width() const { return impl_->picture_.width(); }
int Renderer::height() const { return impl_->picture_.height(); }
BodyBuffer& Renderer::bodies() { return impl_->bodies_; }
Sheet& Renderer::sheet() { return impl_->sheet_; }

void Renderer::set_options(const RenderOptions& options) { impl_->set_options(options); }
void Renderer::resize(int width, int height) { impl_->resize(width, height); }

}  // namespace ballpit
