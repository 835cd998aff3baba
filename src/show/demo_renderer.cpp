// SPDX-License-Identifier: MIT
#include "show/demo_renderer.h"

#include <chrono>

namespace ballpit {

DemoRenderer::DemoRenderer(int width, int height, const RenderOptions& options)
    : renderer_(width, height, options), by_cuda_(make_cuda_body_writer()) {}

void DemoRenderer::draw(Demo& demo, RenderOptions options) {
  options.theme = theme_named(demo.view.theme);
  options.text_scale = demo.view.text_scale;
  options_ = options;
  const auto width = static_cast<float>(renderer_.width() - options.left),
             height = static_cast<float>(renderer_.height());
  if (!demo.is_comparing()) return draw_view(demo, width / height);
  demo.keep_together();
  renderer_.set_options(options);
  renderer_.draw(demo.heading());
  const std::vector<Room> rooms = demo.rooms(width / height);
  for (size_t k = 0; k < rooms.size(); ++k) {
    options_.beside = rooms[k];
    draw_view(demo.view_at(k), width / height * rooms[k].width() / rooms[k].height(), rooms[k].height());
  }
}

void DemoRenderer::draw_view(Demo& demo, float aspect, float share) {
  renderer_.set_options(options_);
  const bool with_occluders =
      demo.shows_occlusion(static_cast<int>(share * static_cast<float>(renderer_.height() * options_.supersample)));
  const auto start = std::chrono::steady_clock::now();
  const bool is_written = write(demo, with_occluders);
  demo.writing_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  renderer_.draw(demo.frame_view(aspect, is_written, with_occluders, share));
}

bool DemoRenderer::write(Demo& demo, bool with_occluders) {
  if (copies_) {
    path_ = "copied";
    return false;
  }
  World& world = demo.session.world();
  if (demo.session.backend() == "cpu") {
    if (by_cuda_) by_cuda_->release();
    renderer_.bodies().resize(world.shape(), with_occluders);
    renderer_.bodies().map([&](const BodyTarget& target) { world.write_bodies(target); });
    path_ = "written by cpu";
    return true;
  }
  const bool is_written = by_cuda_->write(world, renderer_.bodies(), with_occluders);
  const std::string path = is_written ? "written by cuda" : "copied: " + by_cuda_->trouble();
  if (!is_written && path != path_) demo.say("the GPU's spheres are copied to be drawn: " + by_cuda_->trouble());
  path_ = path;
  return is_written;
}

}  // namespace ballpit
