// SPDX-License-Identifier: MIT
// Every built-in scene fills its picture, of any usual shape, and does not change its size while the camera turns.
#include <algorithm>
#include <cmath>
#include <map>

#include <catch2/catch.hpp>

#include "scene/read_scene.h"
#include "show/demo.h"

using namespace ballpit;

namespace {

constexpr float kShapes[] = {16.0f / 9, 4.0f / 3, 9.0f / 16};
constexpr float kFilled = 0.88f;  // of the picture's width or height; the rest is margin

/// What is seen in a picture from −1 to 1.
struct Area {
  Vec2 low{9.0f}, high{-9.0f};

  void add(Vec2 at) {
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  /// The part of the picture's width or height that lies between, the greater of the two.
  float share() const {
    const Vec2 size = glm::min(high, Vec2(1)) - glm::max(low, Vec2(-1));
    return std::max(size.x, size.y) / 2;
  }
};

Vec2 place_of(const Camera& camera, const Vec3& point) {
  const Vec4 clip = camera.projection() * camera.view() * Vec4(point, 1);
  return Vec2(clip.x, clip.y) / clip.w;
}

Area box_in(const FrameView& view) {
  const auto [min, max] = view.domain.framed.value_or(FramedBox{view.domain.min, view.domain.max});
  Area seen;
  for (int k = 0; k < 8; ++k) seen.add(place_of(view.camera, corner_of(min, max, k)));
  return seen;
}

Area spheres_in(const FrameView& view) {
  const BodySnapshot& bodies = view.inspection.bodies;
  const Vec3 forward = normalize(view.camera.target - view.camera.eye);
  const Vec3 right = normalize(glm::cross(forward, view.camera.up)), up = glm::cross(right, forward);
  Area seen;
  for (int64_t i = 0; i < bodies.count; ++i) {
    for (const Vec3& out : {right, -right, up, -up}) {
      seen.add(place_of(view.camera, bodies.position_of(i) + bodies.radius_of(i) * out));
    }
  }
  return seen;
}

}  // namespace

TEST_CASE("every built-in scene fills pictures of 16:9, 4:3 and 9:16 up to a margin, and its spheres most of them") {
  // Scenes of few spheres, whose way through the box is what fills it.
  const std::map<std::string, float> few{{"bouncing-ball", 0.15f}, {"pi", 0.3f}, {"bullet", 0.33f}};
  for (const SceneInfo& info : built_in_scenes()) {
    Demo demo(info.name, {});
    demo.view.overlays.clear();  // their notes would need room
    const auto found = few.find(info.name);
    for (const float aspect : kShapes) {
      CAPTURE(info.name, aspect);
      const FrameView view = demo.frame_view(aspect);
      const Area box = box_in(view);
      CHECK(box.share() == Approx(kFilled).epsilon(2e-3));
      CHECK(std::max({-box.low.x, -box.low.y, box.high.x, box.high.y}) < kFilled + 2e-3f);
      const float spheres = spheres_in(view).share();
      CHECK(spheres > (found == few.end() ? 0.45f : found->second));
    }
  }
}

TEST_CASE("a turning camera shows the box at the same size at every angle, and goes round once in 360 degrees") {
  Demo demo("bouncing-balls", {{"count", "20"}, {"dt", "0.1"}, {"response", "kinematic"}, {"max-overlap", "1e6"}});
  const DomainBox box = demo.frame_view(1).domain;
  const float still = length(camera_of(demo.view, box, 1.5f).eye - camera_of(demo.view, box, 1.5f).target);
  demo.view.turn = 90;
  for (const float aspect : kShapes) {
    const Camera first = camera_of(demo.view, box, aspect);
    const Vec3 middle = (box.min + box.max) / 2.0f;
    float widest = 0;
    for (int k = 0; k < 72; ++k) {
      const Camera turned = camera_of(demo.view.turned(k / 18.0), box, aspect);
      CHECK(turned.eye.y == Approx(first.eye.y));
      CHECK(length(turned.eye - middle) == Approx(length(first.eye - middle)));
      Area area;
      for (int corner = 0; corner < 8; ++corner) area.add(place_of(turned, corner_of(box.min, box.max, corner)));
      CHECK(std::max({-area.low.x, -area.low.y, area.high.x, area.high.y}) < kFilled + 2e-3f);
      widest = std::max(widest, area.share());
    }
    CHECK(widest > 0.8f);
    CHECK(length(camera_of(demo.view.turned(4), box, aspect).eye - first.eye) < 1e-4f * length(first.eye));
  }
  CHECK(length(camera_of(demo.view, box, 1.5f).eye - camera_of(demo.view, box, 1.5f).target) > still);
}

TEST_CASE("the camera turns with the scene's time, and its speed changes without a leap") {
  Demo demo("bouncing-balls", {{"count", "20"}});
  demo.view.turn = 30;
  demo.touch();
  const Vec3 before = demo.frame_view(1.5f).camera.eye;
  demo.advance_to(0.5, [] { return false; });
  const Vec3 after = demo.frame_view(1.5f).camera.eye;
  const Vec3 middle(3, 0, 2);
  const Vec2 from(before.x - middle.x, before.z - middle.z), to(after.x - middle.x, after.z - middle.z);
  CHECK(dot(normalize(from), normalize(to)) == Approx(std::cos(15 * 3.14159265f / 180)).epsilon(1e-4));
  demo.view.set_turn(6, demo.session.time());
  demo.touch();
  CHECK(length(demo.frame_view(1.5f).camera.eye - after) < 1e-4f * length(after));
  CHECK(demo.view.turn == 6);
}
