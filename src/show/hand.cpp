// SPDX-License-Identifier: MIT
#include "show/hand.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numbers.h"
#include "core/phrase.h"

namespace ballpit {

namespace {

/// Where a ray meets the plane through `point` across `normal`; empty if that is behind the viewer.
std::optional<Vec3> meet(const Ray& ray, const Vec3& point, const Vec3& normal) {
  const float ahead = dot(point - ray.from, normal) / dot(ray.along, normal);
  if (!(ahead > 0) || !std::isfinite(ahead)) return std::nullopt;
  return ray.from + ahead * ray.along;
}

/// The point under the pointer in the plane through `point` that faces the viewer.
std::optional<Vec3> facing(const Camera& camera, Vec2 place, const Vec3& point) {
  return meet(ray_through(camera, place), point, normalize(camera.target - camera.eye));
}

float mean_speed(const BodySnapshot& bodies) {
  float sum = 0;
  for (int64_t i = 0; i < bodies.count && !bodies.velocity.empty(); ++i) sum += length(bodies.velocity_of(i));
  return bodies.count > 0 ? sum / static_cast<float>(bodies.count) : 0;
}

/// [s] in which a thrown sphere moves by the length of the arrow.
float time_of_arrow(const Scene& scene, const BodySnapshot& bodies) {
  constexpr float kFast = 10, kUsual = 0.25f;  // times the spheres' speed; [s] for spheres at rest
  const Vec3d size = scene.domain.max - scene.domain.min;
  const double g = length(scene.physics.gravity);
  if (g > 0) return static_cast<float>(std::sqrt(size.y / (2 * g)));  // v = √(2gh)
  const float speed = mean_speed(bodies);
  return speed > 0 ? static_cast<float>(size.y) / (kFast * speed) : kUsual;
}

/// [m/s] With more, a sphere of this radius [m] could leave through a wall or pass through another one.
float fastest_of(const Settings& settings, double radius) {
  constexpr double kRadii = 0.9;
  if (settings.response == Response::event_driven || settings.is_swept) return std::numeric_limits<float>::infinity();
  return static_cast<float>(kRadii * radius * settings.substeps / settings.dt);
}

/// [m] By how much a new sphere is too near to sphere i; 0 or less if it is not.
double overlap_of(const Domain& domain, const Bodies& bodies, size_t i, const Vec3d& place, double radius) {
  return radius + bodies.radius[i] - distance_in(domain, place, bodies.position[i]);
}

std::string speed_text(double speed) { return local_number(three_digits(speed)); }

}  // namespace

bool Hand::grab(const FrameView& view, Vec2 place, ActKind kind) {
  const BodySnapshot& bodies = view.inspection.bodies;
  const int64_t grabbed = body_at(view.camera, bodies, place);
  if (grabbed < 0) return false;
  const Scene& scene = demo_.session.scene();
  const Vec3 centre = bodies.position_of(grabbed);
  act_ = {.kind = kind, .sphere = grabbed};
  act_.reach = kind == ActKind::push ? kHandful * bodies.radius_of(grabbed) : 0;
  Aim aim{.from = centre, .to = centre};
  float smallest = bodies.radius_of(grabbed);
  for (int64_t i = 0; i < bodies.count; ++i) {
    const Vec3 other = bodies.position_of(i);
    if (i != grabbed && !(distance_in(scene.domain, Vec3d(centre), Vec3d(other)) <= act_.reach)) continue;
    aim.rings.push_back({other, bodies.radius_of(i)});
    smallest = std::min(smallest, bodies.radius_of(i));
  }
  fastest_ = fastest_of(demo_.session.settings(), smallest);
  time_ = time_of_arrow(scene, bodies);
  demo_.aim = std::move(aim);
  demo_.touch();
  return true;
}

void Hand::drag(const FrameView& view, Vec2 place) {
  if (!demo_.aim) return;
  Aim& aim = *demo_.aim;
  const std::optional<Vec3> to = facing(view.camera, place, aim.from);
  if (!to) return;
  Vec3 velocity = (*to - aim.from) / time_;
  if (demo_.session.scene().domain.dimensions == 2) velocity.z = 0;
  aim.is_fastest = length(velocity) > fastest_;
  if (aim.is_fastest) velocity *= fastest_ / length(velocity);
  aim.to = aim.from + time_ * velocity;
  aim.speed = length(velocity);
  act_.vector = Vec3d(velocity);
  demo_.touch();
}

void Hand::release() {
  if (!demo_.aim) return;
  const size_t moved = demo_.aim->rings.size();
  const std::string speed = speed_text(demo_.aim->speed);
  demo_.aim.reset();
  act(act_, act_.kind == ActKind::to_throw ? phrase("sphere {} is thrown at {} m/s", act_.sphere, speed)
                                           : phrase("spheres that are pushed by {} m/s: {}", speed, moved));
}

void Hand::cancel() {
  demo_.aim.reset();
  demo_.touch();
}

void Hand::drop(const FrameView& view, Vec2 place) {
  const Session& session = demo_.session;
  const Bodies bodies = demo_.session.world().bodies();
  const SphereSize size = typical_sphere(session.scene(), bodies);
  const std::optional<Vec3d> at = free_place(view, place, size.radius);
  if (!at) return demo_.say(translated("no sphere can be dropped there: it is outside of the domain")), demo_.touch();
  for (size_t i = 0; i < bodies.position.size(); ++i) {
    const double overlap = overlap_of(session.scene().domain, bodies, i, *at, size.radius);
    if (overlap <= 0) continue;
    demo_.say(phrase("no room for a sphere there: sphere {} is {} m too near", i, local_number(three_digits(overlap))));
    return demo_.touch();
  }
  act({.kind = ActKind::drop, .vector = *at, .radius = size.radius, .mass = size.mass},
      translated("a sphere is dropped in"));
}

/// Acts now, and says what was done, or why it could not be.
void Hand::act(const Act& act, const std::string& done) {
  const auto later =
      static_cast<int64_t>(demo_.session.acts().all().size()) - demo_.session.acts().count_until(demo_.session.time());
  demo_.act(act);
  if (!demo_.message().empty()) return;
  demo_.say(later > 0 ? phrase("{}; later acts that are forgotten: {}", done, later) : done);
}

/// [m] The centre of a sphere that is dropped in; empty outside of the domain.
std::optional<Vec3d> Hand::free_place(const FrameView& view, Vec2 place, double radius) const {
  const Scene& scene = demo_.session.scene();
  const Domain& domain = scene.domain;
  const Ray ray = ray_through(view.camera, place);
  const Vec3 low(domain.min), high(domain.max), middle = (low + high) / 2.0f;
  const bool is_planar = domain.dimensions == 2, falls = scene.physics.gravity.y < 0;
  std::optional<Vec3> met;
  if (is_planar) {
    met = meet(ray, Vec3(0), {0, 0, 1});
  } else if (!falls) {
    met = facing(view.camera, place, middle);
  } else if (const int64_t below = body_at(view.camera, view.inspection.bodies, place); below >= 0) {
    met = view.inspection.bodies.position_of(below);
  } else {
    met = meet(ray, low, {0, 1, 0});
  }
  if (!met) return std::nullopt;
  Vec3d p(*met);
  if (!is_planar && falls) p.y = domain.max.y - radius;
  for (int axis = 0; axis < domain.dimensions; ++axis) {
    if (p[axis] < domain.min[axis] || p[axis] > domain.max[axis]) return std::nullopt;
    if (domain.boundary == Boundary::periodic) continue;
    p[axis] = std::max(std::min(p[axis], domain.max[axis] - radius), domain.min[axis] + radius);
  }
  return fits_inside(domain, p, radius) ? std::optional(p) : std::nullopt;
}

}  // namespace ballpit
