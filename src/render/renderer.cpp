// SPDX-License-Identifier: MIT
#include "render/renderer.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/language.h"
#include "render/gl_context.h"
#include "render/overlays/overlay.h"
#include "render/page_view.h"

namespace ballpit {

namespace {

/// Returns `side`. Throws UserError unless the device can draw pictures of that size.
int checked_side(int width, int height, int side) {
  GLint texture = 0;
  GLint viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const int largest = std::min({texture, viewport[0], viewport[1]});
  if (width >= 1 && height >= 1 && width <= largest && height <= largest) return side;
  throw UserError("--size", fmt::format("{}x{} pixels, supersampling included", width, height),
                  fmt::format("sides of 1 to {} pixels here", largest));
}

/// In the layout of shaders/frame/frame.glsl (std140).
struct FrameBlock {
  Mat4 view, projection;
  Vec4 key_light, halfway, sky, units, shadow, box, sides[5], background, floor, rim, mark_color[2 + kScaleColors];
  Vec2 viewport;
  float pixel, line_unit;
  Vec4 rays;
};

/// A side of the box that shows its back to the viewer is left out, as in a room cut open.
void set_sides(FrameBlock& uniforms, const Vec3& towards_eye) {
  constexpr float kFloor = 0.4f, kWall = 0.12f;  // what they hide; they are bright, so they give back the rest
  const std::array<Vec3, 5> normals{Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)};
  for (size_t k = 0; k < normals.size(); ++k) {
    const float facing = glm::smoothstep(0.0f, 0.2f, dot(normals[k], normalize(towards_eye)));
    uniforms.sides[k] = Vec4(Vec3(uniforms.view * Vec4(normals[k], 0)), 0.5f * facing * (k == 0 ? kFloor : kWall));
  }
}

/// For all shaders used from now on: for a view in this part of a picture of this height [pixel], its lower left first.
void set_uniforms(const GlBuffer& buffer, const FrameView& view, const Theme& theme, const Vec4& part, int whole) {
  FrameBlock uniforms;
  const Vec2 first(part.x, part.y), size(part.z, part.w);
  const DomainBox& domain = view.domain;
  const Camera camera = in_units(view.camera, domain.min, domain.longest_edge());
  uniforms.view = camera.view();
  uniforms.projection = camera.projection();
  // The light is behind the viewer's left shoulder and moves with the camera, so the lit sides are always visible.
  const Vec3 light = normalize(Vec3(-0.5f, 0.75f, 0.75f));
  uniforms.key_light = Vec4(light, theme.key);
  uniforms.halfway = Vec4(normalize(light + Vec3(0, 0, 1)), 0);
  uniforms.sky = Vec4(Vec3(uniforms.view * Vec4(0, 1, 0, 0)), theme.ambient);
  uniforms.units = Vec4(domain.min, 1 / domain.longest_edge());
  uniforms.shadow = Vec4(theme.shadow, theme.edge, 0, 0);
  uniforms.box = Vec4((domain.max - domain.min) / domain.longest_edge(), 0);
  set_sides(uniforms, view.camera.eye - (domain.min + domain.max) / 2.0f);
  uniforms.background = Vec4(theme.background, 1);
  uniforms.floor = Vec4(theme.floor, 1);
  uniforms.rim = Vec4(rim_of(theme.contact), 0);
  for (int mark = 0; mark < 2 + kScaleColors; ++mark) {
    uniforms.mark_color[mark] = Vec4(color_of(theme, mark), rim_width(theme, mark));
  }
  uniforms.viewport = size;
  uniforms.pixel = camera.pixel_size(1.0f, static_cast<int>(size.y));
  const Mat4& p = uniforms.projection;
  const Vec2 stretched(p[0][0], p[1][1]), shifted(p[2][0], p[2][1]);
  uniforms.rays = Vec4(2.0f / (size * stretched), (shifted - 1.0f - 2.0f * first / size) / stretched);
  uniforms.line_unit = static_cast<float>(whole) / 1080.0f;
  glNamedBufferData(buffer.name(), sizeof(uniforms), &uniforms, GL_DYNAMIC_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer.name());
}

constexpr float kWidth = 4.0f;  // of edges [1/1080 of the picture's height]
constexpr float kRise = 0.1f;   // of the box's height: by how much upright edges of an open box are longer

/// Planar scenes have no floor.
void draw_floor(const DomainBox& domain, Painter& painter) {
  if (domain.is_planar()) return;
  const Vec3 size = domain.max - domain.min;
  painter.faces.draw({{domain.min, {size.x, 0, 0}, {0, 0, size.z}, to_rgba(painter.theme.floor)}});
}

/// The edges of the box. Without a ceiling, the upright ones continue above it and fade.
void draw_edges(const DomainBox& domain, Painter& painter) {
  const Rgba color = to_rgba(painter.theme.domain), faded = to_rgba(painter.theme.domain, 0);
  const Vec3 low = domain.min, size = domain.max - low, x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  std::vector<Line> lines;
  const auto add = [&](const Vec3& from, const Vec3& to) { lines.push_back({from, color, to, color}); };
  for (const Vec3& corner : domain.open_top ? std::vector{low} : std::vector{low, low + y}) {
    add(corner, corner + x);
    if (domain.is_planar()) continue;
    add(corner + x, corner + x + z);
    add(corner + x + z, corner + z);
    add(corner + z, corner);
  }
  for (const Vec3& foot :
       domain.is_planar() ? std::vector{low, low + x} : std::vector{low, low + x, low + z, low + x + z}) {
    add(foot, foot + y);
    if (domain.open_top) lines.push_back({foot + y, color, foot + y + kRise * y, faded});
  }
  painter.lines.draw(lines, kWidth * painter.line_unit);
}

/// Where to draw a picture that is averaged afterwards; none if it is drawn as it is.
std::optional<RenderTarget> large_target(const RenderTarget& picture, int supersample) {
  if (supersample < 1 || supersample > 4) throw UserError("--supersample", std::to_string(supersample), "1 to 4");
  if (supersample == 1) return std::nullopt;
  return RenderTarget(picture.width * supersample, picture.height * supersample);
}

void draw_overlays(const FrameView& view, Painter& painter, bool before_bodies) {
  for (const OverlayEntry& entry : overlay_table()) {
    if (!view.shows(entry.name)) continue;
    const std::string lack = before_bodies ? "" : entry.lack(view.inspection);
    if (!lack.empty()) painter.note(translated(entry.label) + ": " + translated(lack));
    if (before_bodies == (entry.is_under_discs && view.domain.is_planar())) entry.draw(view, painter);
  }
}

}  // namespace

PictureRect RenderOptions::part_of(int width, int height) const {
  const auto at = [](float fraction, int side) {
    return static_cast<int>(std::lround(fraction * static_cast<float>(side)));
  };
  const int x = at(beside.left, width - left), y = at(beside.above, height);
  return {left + x, y, at(1 - beside.right, width - left) - x, at(1 - beside.below, height) - y};
}

RenderTarget::RenderTarget(int its_width, int its_height)
    : width(checked_side(its_width, its_height, its_width)), height(checked_side(its_width, its_height, its_height)) {
  glTextureStorage2D(color.name(), 1, GL_RGBA8, width, height);
  glTextureStorage2D(depth.name(), 1, GL_DEPTH_COMPONENT32F, width, height);
  check_gl(fmt::format("making a picture of {}x{} pixels", width, height));
  glNamedFramebufferTexture(framebuffer.name(), GL_COLOR_ATTACHMENT0, color.name(), 0);
  glNamedFramebufferTexture(framebuffer.name(), GL_DEPTH_ATTACHMENT, depth.name(), 0);
  const GLenum status = glCheckNamedFramebufferStatus(framebuffer.name(), GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw RunError("OpenGL", fmt::format("cannot draw into the picture: framebuffer status {}", status));
  }
}

void RenderTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  glViewport(0, 0, width, height);
}

Renderer::Renderer(int width, int height, const RenderOptions& options)
    : options_(options), picture_(width, height), large_(large_target(picture_, options.supersample)) {
  sheet_.begin(width, height, options.part_of(width, height));
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
  const PictureRect part = options_.part_of(width(), height());
  sheet_.begin(width(), height(), part, options_.text_scale);
  const Vec4 pixels(part.left, height() - part.top - part.height, part.width, part.height);
  set_uniforms(uniforms_, view, options_.theme, static_cast<float>(options_.supersample) * pixels, canvas().height);
  if (bodies_.has_occluders() && !(view.page && view.page->has_no_scene)) {
    if (!occlusion_) occlusion_.emplace();
    occlusion_->make_floor_map(bodies_, view.domain);
  }
  canvas().bind();
  limit_to(part, options_.supersample);
  set_state();
  draw_scene(view, coloring, colored);
  if (large_) {
    picture_.bind();
    limit_to(part, 1);
    average();
  }
  glDisable(GL_SCISSOR_TEST);
  picture_.bind();
  sheet_.draw();
  check_gl("drawing a frame");
}

void Renderer::set_state() {
  glUseProgram(0);  // the one in use may be deleted, with another renderer, as soon as it is not used
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
  const int height = sheet_.height() * options_.supersample;
  Painter painter{lines_, faces_, sheet_, options_.theme, static_cast<float>(canvas().height) / 1080.0f};
  const auto width = static_cast<float>(sheet_.width());
  painter.note_width = (view.domain.is_planar() ? 0.2f : 0.45f) * width;
  if (view.notes.width > 0) {
    painter.note_width = view.notes.width * width;
    painter.wraps_sentences = true;
    painter.note_skip = view.notes.skip * static_cast<float>(sheet_.height());
  }
  if (!colored.marks.empty()) painter.marks = &colored.marks;
  if (view.page) {
    draw_page(*view.page, painter);
    if (view.page->has_no_scene) return;
  }
  if (bodies_.has_occluders()) {
    occlusion_->draw_floor();
    occlusion_->draw_bodies(bodies_, canvas().depth);
  } else {
    draw_floor(view.domain, painter);
    draw_overlays(view, painter, true);
    const bool are_small = SmallSphereRenderer::suits(bodies_, view, height);
    if (are_small && !small_) small_.emplace(draws_in_software());
    are_small ? small_->draw(bodies_, view) : body_renderer_.draw(bodies_, view, height);
  }
  draw_overlays(view, painter, false);
  draw_edges(view.domain, painter);
  draw_aim(view, painter);
  if (view.domain.framed && view.notes.above > 0) {  // the strip of the notes ends what rises above the framed part
    const float bottom = painter.noted + view.notes.above * static_cast<float>(sheet_.height());
    sheet_.box({0, painter.noted}, {width, bottom}, to_rgba(options_.theme.background));
  }
  painter.draw_notes();
  draw_legend(coloring, colored, painter);
  covered_ = std::move(painter.covered);
}

/// Draws into a part of the picture only, which is `scale` times as large in the bound framebuffer. Beside other views
/// the scissor also holds back clearing, and points that are cut by the part's edge.
void Renderer::limit_to(const PictureRect& part, int scale) {
  const int bottom = height() - part.top - part.height;
  glViewport(part.left * scale, bottom * scale, part.width * scale, part.height * scale);
  if (options_.beside == Room{}) return;
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.left * scale, bottom * scale, part.width * scale, part.height * scale);
}

/// Draws the large picture into the one of final size.
void Renderer::average() {
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  average_.set("per_side", options_.supersample);
  average_.use();
  glBindTextureUnit(0, large_->color.name());
  glBindVertexArray(no_attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Image Renderer::read_pixels() {
  Image image{width(), height(), {}};
  const size_t row = static_cast<size_t>(image.width) * 4;
  image.pixels.resize(row * static_cast<size_t>(image.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_.framebuffer.name());
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
  glBlitNamedFramebuffer(picture_.framebuffer.name(), 0, 0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  check_gl("showing a frame");
}

}  // namespace ballpit
