// SPDX-License-Identifier: MIT
#include "show/demo_renderer.h"

namespace ballpit {

namespace {

class CpuBodyWriter final : public BodyWriter {
 public:
  bool write(World& world, BodyBuffer& buffer) override {
    buffer.resize(world.shape());
    buffer.map([&](const BodyTarget& target) { world.write_bodies(target); });
    return true;
  }
};

}  // namespace

DemoRenderer::DemoRenderer(int width, int height, const RenderOptions& options)
    : renderer_(width, height, options),
      by_cuda_(make_cuda_body_writer()),
      by_cpu_(std::make_unique<CpuBodyWriter>()) {}

void DemoRenderer::draw(Demo& demo, RenderOptions options) {
  options.theme = theme_named(demo.view.theme);
  renderer_.set_options(options);
  const bool is_written = write(demo);
  const auto width = static_cast<float>(renderer_.width() - options.left),
             height = static_cast<float>(renderer_.height());
  renderer_.draw(demo.frame_view(width / height, is_written));
}

bool DemoRenderer::write(Demo& demo) {
  if (copies_) {
    path_ = "copied";
    return false;
  }
  const std::string& backend = demo.session.backend();
  BodyWriter& writer = backend == "cuda" ? *by_cuda_ : *by_cpu_;
  if (by_cuda_ && &writer != by_cuda_.get()) by_cuda_->release();
  const bool is_written = writer.write(demo.session.world(), renderer_.bodies());
  const std::string path = is_written ? "written by " + backend : "copied: " + writer.trouble();
  if (!is_written && path != path_) demo.say("the GPU's spheres are copied to be drawn: " + writer.trouble());
  path_ = path;
  return is_written;
}

}  // namespace ballpit
