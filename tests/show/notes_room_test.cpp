// SPDX-License-Identifier: MIT
// Notes and legends do not cover the scene.
#include "render/notes_room.h"

#include <catch2/catch.hpp>

#include "render/gl_context.h"
#include "scene/read_scene.h"
#include "show/demo_renderer.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

const std::vector<std::vector<std::string>> kOverlays{{}, {"pairs"}, {"grid"}, {"grid", "pairs"}};

/// Draws the scene in this size, and checks that its notes and its legend keep clear of the domain and of each other.
void check_room(Demo& demo, DemoRenderer& drawing) {
  const auto width = static_cast<float>(drawing.renderer().width()),
             height = static_cast<float>(drawing.renderer().height());
  demo.touch();
  drawing.draw(demo, RenderOptions{});
  const FrameView view = demo.frame_view(width / height);
  const std::vector<PixelRect>& covered = drawing.renderer().covered();
  for (size_t k = 0; k < covered.size(); ++k) {
    const auto& [low, high] = covered[k];
    INFO(low.x << ", " << low.y << " to " << high.x << ", " << high.y);
    CHECK_FALSE(overlaps_domain(view.domain, view.camera, low, high, {width, height}));
    CHECK((low.x >= 0 && low.y >= 0 && high.x <= width && high.y <= height));
    for (size_t other = 0; other < k; ++other) {
      const auto& [its_low, its_high] = covered[other];
      const bool apart =
          high.x <= its_low.x + 1 || its_high.x <= low.x + 1 || high.y <= its_low.y + 1 || its_high.y <= low.y + 1;
      CHECK(apart);
    }
  }
}

}  // namespace

TEST_CASE("notes and legends cover neither the domain nor each other, in every scene, with pairs and grid", "[slow]") {
  const GlContext context(-1);
  DemoRenderer wide(960, 540, {}), square(720, 540, {}), upright(540, 960, {});
  for (const SceneInfo& scene : built_in_scenes()) {
    Demo demo(std::string(scene.name), {});
    for (const ColoringEntry& coloring : coloring_table()) {
      for (const std::vector<std::string>& overlays : kOverlays) {
        INFO(scene.name << ", " << coloring.name << ", " << overlays.size() << " overlays");
        demo.view.coloring = coloring.name;
        demo.view.overlays = overlays;
        check_room(demo, wide);
        if (overlays.size() < 2 || coloring.name != coloring_table().back().name) continue;
        check_room(demo, square);
        check_room(demo, upright);
      }
    }
  }
}

TEST_CASE("the notes of a method that misses contacts, and of one without cells, have room, also below a title") {
  const GlContext context(-1);
  DemoRenderer wide(960, 540, {});
  for (const std::vector<GivenOption>& given :
       std::vector<std::vector<GivenOption>>{{{"broadphase", "linked-cell"}, {"cell-size", "0.5"}},
                                             {{"broadphase", "sort-and-sweep"}},
                                             {{"broadphase", "brute-force"}}}) {
    for (const char* scene : {"lecture-grid", "lecture-sweep", "rain", "two-spheres"}) {
      for (const float scale : {1.0f, 1.6f}) {
        for (const bool has_caption : {false, true}) {
          Demo demo(scene, given);
          INFO(scene << ", " << given.front().value << ", " << scale << ", " << has_caption);
          demo.view.coloring = "contacts";
          demo.view.overlays = {"grid", "pairs", "velocity"};
          demo.view.text_scale = scale;
          demo.view.has_caption = has_caption;
          check_room(demo, wide);
        }
      }
    }
  }
}

TEST_CASE("a scene keeps its place while its numbers change, and takes the whole picture without notes") {
  const GlContext context(-1);
  Demo demo("rain", {});
  demo.view.overlays = {"pairs"};
  demo.view.coloring = "contacts";
  const Camera before = demo.frame_view(1.6f).camera;
  demo.advance_to(1.0, [] { return false; });
  demo.touch();
  CHECK(demo.frame_view(1.6f).camera.shift == before.shift);
  CHECK(demo.frame_view(1.6f).camera.fov == before.fov);
  CHECK(before.shift.y < 0);
  demo.view.overlays = {};
  demo.view.coloring = "contact";
  CHECK(demo.frame_view(1.6f).notes.above == 0);
  CHECK(demo.frame_view(1.6f).camera.shift == Vec2(0));
}

TEST_CASE("what rises above the framed part of a scene ends below its title, and what lies below, above its caption") {
  const GlContext context(-1);
  constexpr int kWidth = 960, kHeight = 540;
  for (const char* scene : {"rain", "column", "two-spheres"}) {
    for (const Theme& theme : themes()) {
      Demo demo(scene, {});
      demo.view.overlays.clear();
      demo.view.theme = theme.name;
      demo.view.has_caption = true;
      DemoRenderer drawing(kWidth, kHeight, {.theme = theme});
      demo.touch();
      drawing.draw(demo, RenderOptions{.theme = theme});
      const Image image = drawing.renderer().read_pixels();
      const Room room = room_of(*demo.frame_view(16.0f / 9).page, 1, 16.0f / 9);
      const auto is_ground = [&](float from, float to, int left) {  // from `left` on, to the right of the texts
        for (int y = static_cast<int>(from * kHeight) + 1; y < static_cast<int>(to * kHeight) - 1; ++y) {
          for (int x = left; x < kWidth; ++x) {
            const uint8_t* pixel = image.pixel(x, y);
            if (length(Vec3(pixel[0], pixel[1], pixel[2]) / 255.0f - theme.background) > 0.005f) return false;
          }
        }
        return true;
      };
      INFO(scene << ", " << theme.name);
      CHECK(is_ground(0, room.above, kWidth / 4));
      CHECK_FALSE(is_ground(room.above, 0.5f, 0));
      CHECK(is_ground(1 - room.below, 1, 3 * kWidth / 4));
    }
  }
}

TEST_CASE("a rectangle overlaps the picture of a domain where it covers it, and not beside a slanted edge") {
  const DomainBox box{Vec3(-1), Vec3(1)};
  Camera camera = frame_box(box.min, box.max, 3, 1);
  const Vec2 size(1000, 1000);
  CHECK(overlaps_domain(box, camera, {490, 490}, {510, 510}, size));
  CHECK(overlaps_domain(box, camera, {0, 0}, size, size));
  CHECK_FALSE(overlaps_domain(box, camera, {0, 0}, {1000, 20}, size));
  CHECK_FALSE(overlaps_domain(box, camera, {0, 0}, {90, 90}, size));  // within the bounding box of the corners
  camera.eye = Vec3(0);
  CHECK(overlaps_domain(box, camera, {0, 0}, {1, 1}, size));
}
