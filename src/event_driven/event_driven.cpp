// SPDX-License-Identifier: MIT
#include "event_driven/event_driven.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/interrupt.h"

namespace ballpit {

namespace {

constexpr double kMaxCellsPerSphere = 2;  // with more cells, visiting empty ones costs more than larger ones would
constexpr double kEpoch = 512;  // radii that a sphere flies in an epoch: rounding of times then costs 1e-13 radii
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
// Time stands still if a sphere has so many events in one moment: more than the cascades of any packing. A moment is
// this part of an epoch, or the duration of a contact if that is shorter. Times are rounded to 2^-53 of an epoch: so
// many events in it follow each other within eight roundings. Collisions of an end do not, however fast they come: a
// light ball between a wall and one that is 10^12 times as heavy hits them three million times within 10^-5 s.
constexpr int64_t kStandstill = 1000;
constexpr double kMoment = 0x1p-40;
constexpr int64_t kEventsBetweenChecks = 1024;  // for an interruption of the run: about a millisecond
constexpr double kWedged = 1e-9;      // radii: a sphere with less room between two walls fits exactly between them
constexpr double kRightAngle = 1e-6;  // a smaller component of a normal along an axis is ignored

double largest(const std::vector<double>& values) {
  return values.empty() ? 1.0 : *std::max_element(values.begin(), values.end());
}

/// The axes along which a normal has a component, as bits.
template <class V>
uint8_t axes_of(const V& normal) {
  uint8_t axes = 0;
  for (int axis = 0; axis < kDimensions<V>; ++axis) axes |= uint8_t((std::fabs(normal[axis]) > kRightAngle) << axis);
  return axes;
}

}  // namespace

template <class V>
EventDriven<V>::EventDriven(const Scene& scene, const EventRules<V>& rules)
    : rules_(rules),
      cells_(rules.box, 2 * largest(scene.bodies.radius), 64 + kMaxCellsPerSphere * double(scene.bodies.size()),
             scene.bodies.size()),
      queue_(scene.bodies.size()),
      flights_(scene.bodies.position.size()),
      forecasts_(scene.bodies.position.size()),
      radii_(per_body(scene.bodies.radius)),
      masses_(per_body(scene.bodies.mass)),
      epoch_length_(epoch_length(scene)) {
  for (int i = 0; i < size(); ++i) {
    Flight<V>& flight = flights_[size_t(i)];
    flight.position = rules.box.wrap(narrow<V>(scene.bodies.position[size_t(i)]));
    flight.velocity = narrow<V>(scene.bodies.velocity[size_t(i)]);
    forecasts_[size_t(i)].cell = cells_.cell_of(flight.position);
    cells_.link(i, cell(i));
  }
  for (int i = 0; i < size(); ++i) {
    check(i, flights_[size_t(i)].velocity);
    forecast(i);
  }
}

template <class V>
std::vector<double> EventDriven<V>::per_body(const std::vector<double>& values) {
  const bool is_uniform = std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
  return is_uniform && !values.empty() ? std::vector<double>{values.front()} : values;
}

/// Times count from the start of an epoch, so that their rounding errors do not grow in long runs. Its length is a
/// power of two: subtracting multiples of it from later times is exact.
template <class V>
double EventDriven<V>::epoch_length(const Scene& scene) {
  const Vec3d extent = scene.domain.max - scene.domain.min;
  double speed = std::sqrt(2 * length(scene.physics.gravity) * length(extent));
  for (const Vec3d& v : scene.bodies.velocity) speed = std::max(speed, length(v));
  double radius = length(extent);
  for (const double r : scene.bodies.radius) radius = std::min(radius, r);
  return speed > 0 ? std::ldexp(1.0, std::ilogb(kEpoch * radius / speed)) : 1.0;
}

template <class V>
bool EventDriven<V>::run_until(double time, int64_t max_events) {
  // `time` is converted again for each event: an event may begin a new epoch.
  for (int64_t k = 1; queue_.first_time() <= local(time); ++k) {
    if (k > max_events) return false;
    next_event();
    settled_ = now_;
    if (k % kEventsBetweenChecks == 0) stop_if_interrupted();
  }
  return true;
}

template <class V>
void EventDriven<V>::next_event() {
  if (queue_.first_time() >= epoch_length_) start_epoch();
  const int i = queue_.first();
  const Forecast& f = forecasts_[size_t(i)];
  now_ = f.time();
  flights_[size_t(i)].advance(now_, rules_.gravity);
  if (!(f.contact_time <= f.face_time)) {
    f.is_wall ? hit_wall(i) : cross_face(i);
  } else if (is_void(f)) {
    check(i, flights_[size_t(i)].velocity);
    forecast(i);
  } else {
    collide(i, f.partner);
  }
}

template <class V>
void EventDriven<V>::start_epoch() {
  const double shift = epoch_length_ * std::floor(queue_.first_time() / epoch_length_);
  for (Flight<V>& flight : flights_) flight.time -= shift;
  for (Forecast& f : forecasts_) {
    f.contact_time -= shift;
    f.face_time -= shift;
    f.last_collision -= shift;
  }
  queue_.shift(shift);
  now_ -= shift;
  settled_ -= shift;
  moment_start_ -= shift;
  epoch_start_ += shift;
}

template <class V>
void EventDriven<V>::count_event(int i) {
  ++events_;
  const double contact = rules_.contact_duration > 0 ? rules_.contact_duration : kNever;
  if (now_ - moment_start_ >= std::min(kMoment * epoch_length_, contact)) {
    moment_start_ = now_;
    moment_events_ = 0;
  } else if (++moment_events_ > kStandstill * size()) {
    for (int axis = 0; axis < kDimensions<V>; ++axis) {
      if (!is_wedged(i, axis)) continue;
      fail(i,
           fmt::format(
               "it fits exactly between the walls along {}, and what pushes it there makes it collide without end",
               "xyz"[axis]),
           "a domain with more room ends this");
    }
    const bool is_short = rules_.contact_duration < kMoment * epoch_length_;
    fail(i, "collisions follow each other without end",
         is_short ? "a longer --contact-duration may end them" : "it has no room to move between its neighbours");
  }
}

/// Spheres i and j exchange Δp = (1 + e)·μ·(v12·n)·n, with the reduced mass μ.
template <class V>
void EventDriven<V>::collide(int i, int j) {
  Flight<V>&a = flights_[size_t(i)], &b = flights_[size_t(j)];
  b.advance(now_, rules_.gravity);
  const V d = rules_.box.displacement(a.position, b.position);
  const double distance = length(d);
  const V n = d / distance;
  const double approach = std::max(0.0, dot(a.velocity - b.velocity, n));
  const uint8_t axes = axes_of(n);
  const double e = is_lossless(i, axes) || is_lossless(j, axes) ? 1.0 : rules_.restitution;
  // A least speed of parting ensures that they do not approach after rounding. Otherwise spheres that stay together (e
  // = 0) might creep into each other, and three of them could collide endlessly in one moment.
  const double parting = std::max(e * approach, kRounding * (length(a.velocity) + length(b.velocity)));
  const double share = mass(j) / (mass(i) + mass(j));  // μ / m_i
  const V after_i = a.velocity - (share * (approach + parting)) * n;
  const V after_j = b.velocity + ((1 - share) * (approach + parting)) * n;
  count_event(i);
  check(i, after_i);
  check(j, after_j);
  if (keeps_log_) {
    log_.push_back({epoch_start_ + now_, i, j, widen(after_i - a.velocity), widen(after_j - b.velocity),
                    widen(a.position + radius(i) * n)});
  }
  a.velocity = after_i;
  b.velocity = after_j;

  ++tally_.collisions;
  tally_.virial += share * mass(i) * (approach + parting) * distance;
  for (const int k : {i, j}) {
    ++flights_[size_t(k)].collisions;
    note_collision(k, axes);
  }
  forecast(i);
  forecast(j);
}

template <class V>
void EventDriven<V>::note_collision(int i, uint8_t axes) {
  Forecast& f = forecasts_[size_t(i)];
  f.struck = is_in_contact(i) ? f.struck | axes : axes;
  f.last_collision = now_;
}

/// Whether sphere i fits exactly between the walls of an axis.
template <class V>
bool EventDriven<V>::is_wedged(int i, int axis) const {
  if (rules_.box.is_periodic() || (axis == 1 && rules_.box.boundary == Boundary::open_top)) return false;
  return rules_.box.extent(axis) - 2 * radius(i) <= kWedged * radius(i);
}

/// A wall throws sphere i back, at least so fast that gravity needs the duration of a contact to return it. A sphere
/// that bounces no faster rests on the wall: such a bounce does not count as a collision for the TC model. A sphere
/// that fits exactly between two walls cannot move along their normal.
template <class V>
void EventDriven<V>::hit_wall(int i) {
  const int axis = forecasts_[size_t(i)].axis, side = forecasts_[size_t(i)].side;
  V velocity = flights_[size_t(i)].velocity;
  const double approach = std::max(0.0, side * velocity[axis]);
  const auto axes = static_cast<uint8_t>(1 << axis);
  const double e = is_lossless(i, axes) ? 1.0 : rules_.wall_restitution;
  const double resting = std::max(0.0, 0.5 * rules_.contact_duration * side * rules_.gravity[axis]);
  const double parting = is_wedged(i, axis) ? 0.0 : std::max(e * approach, resting);
  velocity[axis] = -side * parting;
  count_event(i);
  check(i, velocity);
  if (keeps_log_) {
    V place = flights_[size_t(i)].position;
    place[axis] += side * radius(i);
    log_.push_back(
        {epoch_start_ + now_, i, -1, widen(velocity - flights_[size_t(i)].velocity), Vec3d(0.0), widen(place)});
  }
  flights_[size_t(i)].velocity = velocity;

  if (axis == 1 && side < 0) tally_.floor_impulse += mass(i) * (approach + parting);
  ++flights_[size_t(i)].collisions;
  if (parting > resting || approach > 2 * resting) ++tally_.wall_hits;  // the latter without restitution
  if (parting > resting) note_collision(i, axes);
  forecast(i);
}

template <class V>
void EventDriven<V>::cross_face(int i) {
  Forecast& f = forecasts_[size_t(i)];
  count_event(i);
  cells_.unlink(i, f.cell);
  if (cells_.is_border(f.cell, f.axis, f.side)) {  // the domain is periodic: continue at its other end
    f.cell[f.axis] = f.side > 0 ? 0 : cells_.count()[f.axis] - 1;
    flights_[size_t(i)].position[f.axis] -= f.side * rules_.box.extent(f.axis);
  } else {
    f.cell[f.axis] += f.side;
  }
  cells_.link(i, f.cell);
  forecast(i, {f.axis, f.side});
}

/// Throws if the position of sphere i, or the velocity that an event is about to give it, is not valid. Called before
/// an event changes a velocity, so that the flights still are those after the previous event.
template <class V>
void EventDriven<V>::check(int i, const V& velocity) const {
  const V& position = flights_[size_t(i)].position;
  if (rules_.box.holds(rules_.box.wrap(position)) && dot(velocity, velocity) < 1e30) return;  // false for NaN
  const Vec3d p = widen(position), v = widen(velocity);
  fail(i, fmt::format("it left the domain: its centre is at ({:g}, {:g}, {:g}), its velocity ({:g}, {:g}, {:g})", p.x,
                      p.y, p.z, v.x, v.y, v.z));
}

template <class V>
void EventDriven<V>::fail(int i, const std::string& what, const std::string& more) const {
  const std::string where = fmt::format("event {} (t = {:g} s), sphere {}", events_, epoch_start_ + now_, i);
  throw RunError(where, what, more);
}

template <class V>
int64_t EventDriven<V>::bytes() const {
  return static_cast<int64_t>(flights_.size() * sizeof(Flight<V>) + forecasts_.size() * sizeof(Forecast) +
                              (cells_.head().size() + cells_.next().size()) * sizeof(int32_t)) +
         queue_.bytes();
}

template class EventDriven<Vec2d>;
template class EventDriven<Vec3d>;

}  // namespace ballpit
