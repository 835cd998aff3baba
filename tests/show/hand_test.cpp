// SPDX-License-Identifier: MIT
// The hand: what is grabbed, thrown, pushed and dropped by places in the picture.
#include "show/hand.h"

#include <fstream>

#include <catch2/catch.hpp>

#include "render/sheet.h"
#include "tests/support/in_german.h"
#include "tests/support/run_program.h"

using namespace ballpit;

namespace {

/// A demonstration and a hand, in a picture as wide as high.
struct Handled {
  explicit Handled(const std::string& scene, const std::vector<GivenOption>& given = {}) : demo(scene, more(given)) {}

  static std::vector<GivenOption> more(std::vector<GivenOption> given) {
    given.push_back({"threads", "1"});
    return given;
  }
  FrameView view() { return demo.frame_view(1); }

  /// The place in the picture of a point in space.
  Vec2 place_of(const Vec3d& p) {
    const Camera camera = view().camera;
    const Vec4 clip = camera.projection() * camera.view() * Vec4(Vec3(p), 1);
    return Vec2(clip) / clip.w;
  }
  Vec3d at(size_t i) { return demo.session.world().bodies().position[i]; }
  Vec3d velocity(size_t i) { return demo.session.world().bodies().velocity[i]; }
  bool grab(size_t i, ActKind kind = ActKind::to_throw) { return hand.grab(view(), place_of(at(i)), kind); }
  void drag_by(size_t i, const Vec3d& way) { hand.drag(view(), place_of(at(i) + way)); }

  Demo demo;
  Hand hand{demo};
};

std::string file_of(const Scratch& scratch, const std::string& text) {
  write_text(scratch / "scene.toml", text);
  return scratch / "scene.toml";
}

}  // namespace

TEST_CASE("a sphere that is dragged and let go gets the velocity of the arrow") {
  Handled handled("lecture-grid");  // 5 × 5 m, without gravity
  REQUIRE(handled.grab(3));
  CHECK(handled.hand.is_aiming());
  const Vec3d before = handled.velocity(3);
  handled.drag_by(3, {0.3, 0.4, 0});
  CHECK(handled.velocity(3) == before);  // not yet
  const float speed = handled.demo.aim->speed;
  handled.drag_by(3, {0.3, -0.4, 0});
  CHECK(handled.demo.aim->speed == Approx(speed).epsilon(1e-4));
  handled.hand.release();
  CHECK_FALSE(handled.hand.is_aiming());
  const Vec3d v = handled.velocity(3);
  CHECK(length(v) == Approx(speed).epsilon(1e-5));
  CHECK(v.y / v.x == Approx(-4.0 / 3).epsilon(1e-3));
  CHECK(v.z == 0);
  CHECK_THAT(handled.demo.message(), Catch::Contains("sphere 3 is thrown at"));
  CHECK(handled.demo.session.acts().all().size() == 1);
}

TEST_CASE("with gravity, an arrow as long as the domain is high throws a sphere that high") {
  Handled handled("bouncing-ball", {{"response", "event-driven"}});
  const Scene& scene = handled.demo.session.scene();
  const double height = scene.domain.max.y - scene.domain.min.y, g = length(scene.physics.gravity);
  REQUIRE(handled.grab(0));
  handled.drag_by(0, {0, 0.25 * height, 0});
  CHECK(handled.demo.aim->speed == Approx(0.25 * std::sqrt(2 * g * height)).epsilon(0.2));  // the view is from above
}

TEST_CASE("a throw is no faster than a step of the response allows, event-driven motion has no limit") {
  for (const auto& [response, is_limited] : {std::pair{"impulse", true}, {"event-driven", false}}) {
    Handled handled("lecture-grid", {{"response", response}, {"dt", "0.05"}});
    REQUIRE(handled.grab(0));
    handled.drag_by(0, {100, 0, 0});
    CHECK(handled.demo.aim->is_fastest == is_limited);
    const double radius = handled.demo.session.world().bodies().radius[0];
    if (is_limited) CHECK(handled.demo.aim->speed == Approx(0.9 * radius / 0.05));
  }
}

TEST_CASE("a push takes the spheres around, and only those with a ring") {
  Handled handled("lecture-grid");
  const Bodies before = handled.demo.session.world().bodies();
  REQUIRE(handled.grab(10, ActKind::push));
  const size_t rings = handled.demo.aim->rings.size();
  CHECK(rings >= 2);
  CHECK(rings < 20);
  handled.drag_by(10, {0.1, 0, 0});
  handled.hand.release();
  const Bodies after = handled.demo.session.world().bodies();
  size_t moved = 0;
  for (size_t i = 0; i < 20; ++i) {
    const bool is_near = length(before.position[i] - before.position[10]) <= 4 * before.radius[10];
    CHECK((after.velocity[i] != before.velocity[i]) == is_near);
    moved += is_near;
  }
  CHECK(moved == rings);
}

TEST_CASE("nothing is grabbed beside the spheres, and a cancelled throw leaves them") {
  Handled handled("lecture-grid");
  CHECK_FALSE(handled.hand.grab(handled.view(), {0.99f, 0.99f}, ActKind::to_throw));
  CHECK_FALSE(handled.hand.is_aiming());
  handled.hand.drag(handled.view(), {0, 0});
  handled.hand.release();
  REQUIRE(handled.grab(3));
  handled.drag_by(3, {1, 0, 0});
  handled.hand.cancel();
  CHECK_FALSE(handled.hand.is_aiming());
  CHECK(handled.demo.session.acts().all().empty());
}

TEST_CASE("in a planar scene a sphere is dropped where the click is, if there is room") {
  Handled handled("lecture-grid");
  const Vec3d place(1.6, 4.4, 0);
  handled.hand.drop(handled.view(), handled.place_of(place));
  INFO(handled.demo.message());
  REQUIRE(handled.demo.session.world().shape().count == 21);
  CHECK(length(handled.at(20) - place) < 1e-3);
  CHECK(handled.velocity(20) == Vec3d(0.0));
  handled.hand.drop(handled.view(), handled.place_of(place));
  CHECK_THAT(handled.demo.message(), Catch::Matches("no room for a sphere there: sphere 20 is 0\\.[0-9]+ m too near"));
  {
    const InGerman german;
    handled.hand.drop(handled.view(), handled.place_of(place));
  }
  CHECK_THAT(handled.demo.message(),
             Catch::Matches("dort ist kein Platz für eine Kugel: Kugel 20 ist 0,[0-9]+ m zu nah"));
  handled.hand.drop(handled.view(), handled.place_of({-1, 2, 0}));
  CHECK_THAT(handled.demo.message(), Catch::Contains("outside of the domain"));
  CHECK(handled.demo.session.world().shape().count == 21);
}

TEST_CASE("in space a sphere is dropped under the ceiling, above the sphere or the floor that is clicked") {
  Handled handled("rain", {{"count", "20"}});
  const Domain& domain = handled.demo.session.scene().domain;
  const Vec3d floor(0.5 * (domain.min.x + domain.max.x), domain.min.y, 0.5 * (domain.min.z + domain.max.z));
  const auto drop_at = [&](const Vec3d& point) {
    const int64_t n = handled.demo.session.world().shape().count;
    handled.hand.drop(handled.view(), handled.place_of(point));
    INFO(handled.demo.message());
    REQUIRE(handled.demo.session.world().shape().count == n + 1);
    return handled.at(static_cast<size_t>(n));
  };
  const Vec3d first = drop_at(floor);
  CHECK(first.y + handled.demo.session.world().bodies().radius[20] == Approx(domain.max.y));
}

TEST_CASE("where there are no spheres, the first is dropped into the middle of the picture") {
  const Scratch scratch;
  for (const char* const boundary : {"walls", "periodic", "open-top"}) {
    Handled handled(file_of(scratch, std::string("[domain]\nboundary = \"") + boundary + "\"\n"));
    CHECK_FALSE(handled.hand.grab(handled.view(), {0, 0}, ActKind::to_throw));
    handled.hand.drop(handled.view(), {0, 0});
    INFO(boundary << handled.demo.message());
    REQUIRE(handled.demo.session.world().shape().count == 1);
    CHECK(handled.grab(0));
    handled.drag_by(0, {0.1, 0, 0});
    handled.hand.release();
    for (int k = 0; k < 100; ++k) handled.demo.step();
    CHECK(handled.demo.player.failure().empty());
    handled.demo.go_to(0);
    CHECK(handled.demo.session.world().shape().count == 1);  // it was dropped at the first step
  }
}
