// SPDX-License-Identifier: MIT
#include "render/renderer.h"

#include <cstring>

#include <catch2/catch.hpp>
#include <epoxy/gl.h>

#include "core/error.h"
#include "render/gl_context.h"
#include "render/overlays/overlay.h"
#include "render/shader.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

const DomainBox kBox;
const DomainBox kPlane{Vec3(0), Vec3(5, 5, 0), 2, false};

std::vector<Sphere> some_spheres() {
  return {{{0.2f, 0.1f, 0.3f}, 0.1f}, {{0.6f, 0.5f, 0.5f}, 0.15f}, {{0.8f, 0.85f, 0.2f}, 0.12f}};
}

}  // namespace

TEST_CASE("this machine has a context, and describes it") {
  const GlContext context;
  CHECK(!context.info().renderer.empty());
  CHECK(context.info().version.find("4.") == 0);
  CHECK(context.info().platform.find("EGL") == 0);
  for (const EglDeviceInfo& device : list_egl_devices()) CHECK(!device.name.empty());
}

TEST_CASE("a reset of the context by the driver is reported") {
  const GlContext context;
  const Inspection inspection = inspect(some_spheres(), kBox);
  Renderer renderer(64, 36);
  struct Reset {
    decltype(epoxy_glGetGraphicsResetStatus) own = epoxy_glGetGraphicsResetStatus;
    Reset() {
      epoxy_glGetGraphicsResetStatus = [] { return GLenum{GL_INNOCENT_CONTEXT_RESET}; };
    }
    ~Reset() { epoxy_glGetGraphicsResetStatus = own; }
  };
  {
    const Reset reset;
    CHECK_THROWS_WITH(
        renderer.draw(view_of(inspection, kBox, 16.0f / 9)),
        "drawing a frame: the OpenGL context is lost, since the driver has reset the graphics device; start again");
  }
  CHECK_NOTHROW(renderer.draw(view_of(inspection, kBox, 16.0f / 9)));
}

TEST_CASE("two contexts exist side by side, and one outlives the other") {
  auto first = std::make_unique<GlContext>();
  const GlContext second;
  first.reset();
  const Inspection inspection = inspect(some_spheres(), kBox);
  Renderer renderer(64, 36);
  CHECK_NOTHROW(renderer.draw(view_of(inspection, kBox, 16.0f / 9)));
}

TEST_CASE("drawing everything leaves no OpenGL error") {
  const GlContext context;
  for (const DomainBox& domain : {kBox, kPlane}) {
    Inspection inspection = inspect(some_spheres(), domain, 0.25f);
    add_candidates(inspection);
    add_endpoints(inspection, 0);
    add_velocities(inspection, domain);
    Renderer renderer(160, 90);
    std::vector<std::string> all;
    for (const OverlayEntry& entry : overlay_table()) all.emplace_back(entry.name);
    CHECK_NOTHROW(renderer.draw(view_of(inspection, domain, 16.0f / 9, all)));
    CHECK_NOTHROW(renderer.read_pixels());
  }
  CHECK_NOTHROW(check_gl("the test"));
}

TEST_CASE("an OpenGL error becomes a RunError at the next check") {
  const GlContext context;
  glEnable(GL_TEXTURE_BUFFER_OFFSET);
  CHECK_THROWS_WITH(check_gl("the test"), Catch::Contains("the test: OpenGL reports GL_INVALID_ENUM"));
  CHECK_NOTHROW(check_gl("the test"));
}

TEST_CASE("an error names a shader that is missing or lacks a uniform") {
  const GlContext context;
  CHECK_THROWS_WITH(Shader("none.vert", "face.frag"), Catch::Contains("none.vert"));
  const Shader shader("face.vert", "face.frag");
  CHECK_THROWS_WITH(shader.set("nothing", 1), Catch::Contains("face.vert") && Catch::Contains("nothing"));
}

TEST_CASE("the same state gives the same pixels, frame after frame and context after context") {
  const Inspection inspection = inspect(some_spheres(), kBox, 0.25f);
  const FrameView view = view_of(inspection, kBox, 16.0f / 9, {"grid"});
  const Image first = draw(view, 320, 180);
  const GlContext context;
  Renderer renderer(320, 180);
  renderer.draw(view);
  CHECK(renderer.read_pixels().pixels == first.pixels);
  renderer.draw(view);
  CHECK(renderer.read_pixels().pixels == first.pixels);
}

TEST_CASE("deleting any sphere changes the picture") {
  const std::vector<Sphere> spheres = some_spheres();
  const Inspection all = inspect(spheres, kBox);
  const Image whole = draw(view_of(all, kBox, 16.0f / 9), 320, 180);
  for (size_t i = 0; i < spheres.size(); ++i) {
    std::vector<Sphere> fewer = spheres;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    const Inspection rest = inspect(fewer, kBox);
    CHECK(count_different(draw(view_of(rest, kBox, 16.0f / 9), 320, 180), whole) > 50);
  }
}

TEST_CASE("rows go from top to bottom: high spheres are high in the picture") {
  for (const DomainBox& domain : {kPlane, DomainBox{Vec3(0), Vec3(5), 3, true}}) {
    const Inspection inspection = inspect({{{2.5f, 4.2f, 2.5f}, 0.6f}}, domain);
    const Inspection empty = inspect({}, domain);
    const Image image = draw(view_of(inspection, domain, 1), 100, 100);
    const Image without = draw(view_of(empty, domain, 1), 100, 100);
    int upper = 0;
    int lower = 0;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) (y < 50 ? upper : lower) += difference(image.pixel(x, y), without.pixel(x, y)) > 8;
    }
    CHECK(upper > 100);
    CHECK(lower < upper / 10);
  }
}

TEST_CASE("a disc has one colour, and an outline") {
  const Inspection inspection = inspect({{{2.5f, 2.5f, 0}, 1.0f}}, kPlane);
  const Image image = draw(view_of(inspection, kPlane, 1), 200, 200);
  const float radius = 200 * 0.88f / 5;
  const Theme& theme = themes().front();
  for (const float part : {-0.8f, -0.3f, 0.0f, 0.6f, 0.8f}) {
    const int at = 100 + static_cast<int>(part * radius);
    CHECK(difference(image.pixel(at, 100), theme.body) <= 1);
    CHECK(difference(image.pixel(100, at), theme.body) <= 1);
  }
  CHECK(image.pixel(100 + static_cast<int>(radius - 1), 100)[2] < 170);
  CHECK(difference(image.pixel(100 + static_cast<int>(radius + 3), 100), theme.background) == 0);
}

TEST_CASE("an open top has no upper edges") {
  const DomainBox open{Vec3(0), Vec3(1), 3, true};
  const Inspection inspection = inspect({}, kBox);
  const Image closed_box = draw(view_of(inspection, kBox, 16.0f / 9), 320, 180);
  CHECK(count_different(draw(view_of(inspection, open, 16.0f / 9), 320, 180), closed_box) > 200);
}

TEST_CASE("supersampling draws the same design, only smoother") {
  const Inspection inspection = inspect(some_spheres(), kBox);
  const FrameView view = view_of(inspection, kBox, 16.0f / 9);
  const Image plain = draw(view, 320, 180);
  for (const int supersample : {2, 4}) {
    const Image fine = draw(view, 320, 180, {themes().front(), supersample});
    CHECK(fine.width == 320);
    CHECK(count_different(fine, plain) > 0);
    CHECK(count_different(fine, plain) < 320 * 180 / 25);
  }
}

TEST_CASE("frames are opaque") {
  const Inspection inspection = inspect(some_spheres(), kBox, 0.25f);
  const Image image = draw(view_of(inspection, kBox, 1, {"grid"}), 90, 90);
  for (size_t i = 3; i < image.pixels.size(); i += 4) REQUIRE(image.pixels[i] == 255);
}

TEST_CASE("a new size or style takes effect in the next frame") {
  const GlContext context;
  const Inspection inspection = inspect(some_spheres(), kBox);
  Renderer renderer(64, 36);
  renderer.resize(128, 72);
  RenderOptions dark{theme_named("dark"), 2};
  renderer.set_options(dark);
  renderer.draw(view_of(inspection, kBox, 16.0f / 9));
  const Image image = renderer.read_pixels();
  CHECK(image.width == 128);
  CHECK(difference(image.pixel(0, 0), dark.theme.background) <= 1);
}

TEST_CASE("impossible sizes and names are UserErrors that list the valid ones") {
  const GlContext context;
  CHECK_THROWS_AS(Renderer(0, 100), UserError);
  CHECK_THROWS_AS(Renderer(100, -1), UserError);
  CHECK_THROWS_WITH(Renderer(1000000, 1000000), Catch::Contains("1000000x1000000"));
  CHECK_THROWS_AS(Renderer(100, 100, {themes().front(), 5}), UserError);
  CHECK_THROWS_WITH(theme_named("pink"), Catch::Contains("projector, dark"));
}

TEST_CASE("a view beside others is the picture of its own size, and leaves the rest as it is") {
  const GlContext context;
  const Inspection inspection = inspect(some_spheres(), kBox);
  const FrameView view = view_of(inspection, kBox, 1);  // without text, whose size is that of the whole picture's
  for (const int supersample : {1, 2}) {
    CAPTURE(supersample);
    Renderer own(200, 200, {.supersample = supersample}), whole(400, 200, {.supersample = supersample});
    own.draw(view);
    const Image expected = own.read_pixels();
    whole.draw(view_of(inspection, kBox, 2));
    const Image before = whole.read_pixels();
    whole.set_options({.supersample = supersample, .beside = {.left = 0.5f}});
    whole.draw(view);
    const Image after = whole.read_pixels();
    const auto pixel_of = [](const Image& image, int x, int y) {
      uint32_t pixel;
      std::memcpy(&pixel, &image.pixels[static_cast<size_t>(y * image.width + x) * 4], sizeof pixel);
      return pixel;
    };
    int changed = 0, different = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x) {
        changed += pixel_of(after, x, y) != pixel_of(before, x, y);
        different += pixel_of(after, x + 200, y) != pixel_of(expected, x, y);
      }
    }
    CHECK(changed == 0);
    CHECK(different < 40);  // of 40 000: edges are rounded at other places
  }
}
