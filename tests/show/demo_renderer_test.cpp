// SPDX-License-Identifier: MIT
// Bodies that the world writes into the renderer's buffer make the picture that an inspection makes.
#include "show/demo_renderer.h"

#include <catch2/catch.hpp>

#include "render/gl_context.h"

using namespace ballpit;

namespace {

Image by_inspection(Demo& demo, int width, int height) {
  RenderOptions options;
  options.theme = theme_named(demo.view.theme);
  Renderer renderer(width, height, options);
  renderer.draw(
      demo.frame_view(static_cast<float>(width) / static_cast<float>(height), false, demo.shows_occlusion(height)));
  return renderer.read_pixels();
}

/// Not compared by ==, which would print a million numbers where it fails.
bool are_equal(const Image& a, const Image& b) { return a.pixels == b.pixels; }

}  // namespace

TEST_CASE("a written picture is the picture of the inspection, to the bit") {
  const GlContext context;
  const std::string scene = GENERATE("lecture-grid", "bouncing-balls", "cradle", "rain");
  const std::string coloring = GENERATE("contact", "speed");
  CAPTURE(scene, coloring);
  Demo demo(scene, {{"threads", "2"}});
  demo.view.coloring = coloring;
  demo.view.overlays.clear();
  demo.touch();
  DemoRenderer drawing(320, 180, {});
  for (int k = 0; k < 12; ++k) demo.step();
  drawing.draw(demo, {});
  CHECK(drawing.path() == "written by cpu");
  CHECK(are_equal(drawing.renderer().read_pixels(), by_inspection(demo, 320, 180)));
}

TEST_CASE("another scene, with other radii or dimensions, goes into the same buffer") {
  const GlContext context;
  DemoRenderer drawing(320, 180, {});
  Demo demo("lecture-grid", {});
  demo.view.overlays.clear();
  for (const char* scene : {"mass-ratio", "rain", "lecture-sweep", "oblique-pair"}) {
    demo.load(scene);
    drawing.draw(demo, {});
    CAPTURE(scene, demo.message());
    CHECK(are_equal(drawing.renderer().read_pixels(), by_inspection(demo, 320, 180)));
  }
}

TEST_CASE("bodies that are copied make the picture of those that are written, to the bit") {
  const GlContext context;
  const std::string scene = GENERATE("lecture-grid", "bouncing-balls");
  CAPTURE(scene);
  Demo demo(scene, {{"threads", "2"}});
  for (int k = 0; k < 12; ++k) demo.step();
  DemoRenderer written(320, 180, {}), copied(320, 180, {});
  copied.copy_bodies();
  written.draw(demo, {});
  const Image expected = written.renderer().read_pixels();
  copied.draw(demo, {});
  CHECK(copied.path() == "copied");
  CHECK(copied.renderer().read_pixels().pixels == expected.pixels);
}

TEST_CASE("who needs the state is shown it, also where the bodies are written") {
  Demo demo("lecture-grid", {});
  demo.view.overlays.clear();
  CHECK(demo.frame_view(1, true).inspection.bodies.position.empty());
  demo.view.selected = 1;
  demo.touch();
  CHECK_FALSE(demo.frame_view(1, true).inspection.bodies.position.empty());
  demo.view.selected = -1;
  demo.view.coloring = "speed";
  demo.touch();
  CHECK_FALSE(demo.frame_view(1, true).inspection.bodies.position.empty());
  demo.view.coloring = "contact";
  demo.view.overlays = {"grid"};
  demo.touch();
  CHECK_FALSE(demo.frame_view(1, true).inspection.grids.empty());
  demo.view.overlays.clear();
  demo.touch();
  CHECK(demo.frame_view(1, true).inspection.bodies.position.empty());
  CHECK_FALSE(demo.inspection().bodies.position.empty());  // the same state, looked at again
}
