// SPDX-License-Identifier: MIT
#include "event_driven/event_driven.h"

#include <sstream>

#include "core/error.h"
#include "core/interrupt.h"

namespace ballpit {

namespace {

constexpr double kCellsPerSphere = 2;  // at most: emptier cells cost more to visit than crossings saved
constexpr double kEpoch = 512;         // radii that a sphere flies in an epoch: rounding of times costs 1e-13 radii
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
// Time stands still where so many events a sphere fall on one moment, which is a part of an epoch, or the duration of a
// contact if that is shorter: more than the cascades in any packing have.
constexpr int64_t kStandstill = 1000;
constexpr double kMoment = 0x1p-16;
constexpr int64_t kEventsBetweenLooks = 1024;  // whether the run was interrupted: about a millisecond
constexpr double kWedged = 1e-9;      // radii: a sphere with less room between two walls fits exactly between them
constexpr double kRightAngle = 1e-6;  // part of a normal along an axis that does not count
constexpr int kFewestToFetch = 5000;  // spheres; fewer lie in a cache

double largest(const std::vector<double>& values) {
  return values.empty() ? 1.0 : *std::max_element(values.begin(), values.end());
}

/// The axes that a normal has a part along, as bits.
template <class V>
uint8_t axes_of(const V& normal) {
  uint8_t axes = 0;
  for (int axis = 0; axis < kDimensions<V>; ++axis) axes |= uint8_t((std::fabs(normal[axis]) > kRightAngle) << axis);
  return axes;
}

double cell_limit(const Scene& scene) { return 64 + kCellsPerSphere * double(scene.bodies.size()); }

}  // namespace

template <class V>
EventDriven<V>::EventDriven(const Scene& scene, const EventRules<V>& rules)
    : rules_(rules),
      cells_(rules.box, 2 * largest(scene.bodies.radius), cell_limit(scene), scene.bodies.size()),
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

/// Times count from the start of an epoch, so that their rounding does not grow in long runs. Its length is a power of
/// two, since subtracting multiples of it from later times is exact.
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
void EventDriven<V>::run_until(double time) {
  // The end is converted again in each epoch: an epoch begins with an event, not with a step.
  for (int64_t k = 1; queue_.first_time() <= local(time); ++k) {
    next_event();
    settled_ = now_;
    if (k % kEventsBetweenLooks == 0) stop_if_interrupted();
  }
}

template <class V>
void EventDriven<V>::next_event() {
  if (queue_.first_time() >= epoch_length_) start_epoch();
  const int i = queue_.first();
  const Forecast& f = forecasts_[size_t(i)];
  now_ = f.time();
  flights_[size_t(i)].advance(now_, rules_.gravity);
  if (f.contact_time <= f.face_time) {
    is_void(f) ? forecast_anew(i) : collide(i, f.partner);
  } else {
    f.is_wall ? hit_wall(i) : cross_face(i);
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
           std::string("it fits exactly between the walls along ") + "xyz"[axis] +
               ", and what pushes it there makes it collide without end",
           "a domain with more room ends this");
    }
    const bool is_short = rules_.contact_duration < kMoment * epoch_length_;
    fail(i, "collisions follow each other without end",
         is_short ? "a longer --contact-duration may end them" : "it has no room to move between its neighbours");
  }
}

/// Forecasts sphere i, which is at the present, from nothing.
template <class V>
void EventDriven<V>::forecast(int i) {
  forecasts_[size_t(i)].contact_time = kNever;
  forecast_faces(i);
  forecast_contacts(i, {});
  schedule(i);
}

/// The contact that was forecast will not be: the partner has collided meanwhile.
template <class V>
void EventDriven<V>::forecast_anew(int i) {
  check(i, flights_[size_t(i)].velocity);
  forecast(i);
}

/// The block that an event's forecast will look at.
template <class V>
BlockPart EventDriven<V>::part_of(const Forecast& f) const {
  if (f.contact_time <= f.face_time || f.is_wall) return {};
  return {f.axis, f.side};
}

/// Puts the next event of sphere i into the queue, and fetches what the events to come will read, the more the sooner they
/// come: whoever wins among a 64th of all spheres is soon to come, among a quarter sooner.
template <class V>
void EventDriven<V>::schedule(int i) {
  queue_.set(i, forecasts_[size_t(i)].time());
  if (size() < kFewestToFetch || events_ == 0) return;
  const int soon = queue_.first_near(i, 6), sooner = queue_.first_near(i, 4), next = queue_.first_near(i, 2);
  __builtin_prefetch(&flights_[size_t(soon)]);
  __builtin_prefetch(&forecasts_[size_t(soon)]);
  queue_.prefetch(soon);
  const Forecast& f = forecasts_[size_t(sooner)];
  cells_.prefetch_heads(f.cell, part_of(f));
  if (f.partner >= 0) {
    __builtin_prefetch(&flights_[size_t(f.partner)]);
    __builtin_prefetch(&forecasts_[size_t(f.partner)]);
    queue_.prefetch(f.partner);
  }
  const Forecast& g = forecasts_[size_t(next)];
  cells_.prefetch_firsts(g.cell, part_of(g), [&](int body) { __builtin_prefetch(&flights_[size_t(body)]); });
}

/// When does sphere i leave its cell, or meet the wall that ends it?
template <class V>
void EventDriven<V>::forecast_faces(int i) {
  const Flight<V>& flight = flights_[size_t(i)];
  Forecast& f = forecasts_[size_t(i)];
  f.face_time = kNever;
  for (int axis = 0; axis < kDimensions<V>; ++axis) {
    for (const int side : {-1, 1}) {
      const bool is_wall = cells_.is_border(f.cell, axis, side) && !rules_.box.is_periodic();
      if (is_wall && axis == 1 && side > 0 && rules_.box.boundary == Boundary::open_top) continue;
      const double gap = side * (cells_.face(f.cell, axis, side) - flight.position[axis]);
      const double time = now_ + time_to_plane(is_wall ? gap - radius(i) : gap, side * flight.velocity[axis],
                                               side * rules_.gravity[axis]);
      if (time >= f.face_time) continue;
      f.face_time = time;
      f.axis = static_cast<int8_t>(axis);
      f.side = static_cast<int8_t>(side);
      f.is_wall = is_wall;
    }
  }
}

/// Looks for an earlier contact of sphere i in its block, or a part of it. Sphere i itself and its own images have no
/// velocity relative to it, hence no contact.
template <class V>
void EventDriven<V>::forecast_contacts(int i, BlockPart part) {
  const Flight<V>& flight = flights_[size_t(i)];
  Forecast& f = forecasts_[size_t(i)];
  const bool falls = rules_.gravity != V{};
  cells_.gather(f.cell, part, neighbors_);
  predictions_ += static_cast<int64_t>(neighbors_.size());
  // All spheres are fetched at once: among 100 000 this saves a fifth of the time.
  for (const Neighbor& neighbor : neighbors_) __builtin_prefetch(&flights_[size_t(neighbor.body)]);
  for (const Neighbor& neighbor : neighbors_) {
    const int k = neighbor.body;
    const Flight<V>& other = flights_[size_t(k)];
    const double elapsed = now_ - other.time;
    V d = other.position + elapsed * other.velocity + cells_.shift(neighbor) - flight.position;
    V u = other.velocity - flight.velocity;
    if (falls) {
      d += (0.5 * elapsed * elapsed) * rules_.gravity;
      u += elapsed * rules_.gravity;
    }
    const double wait = time_to_contact(d, u, radius(i) + radius(k));
    if (wait == kNever) continue;
    const double time = now_ + wait;
    if (time > f.contact_time || (time == f.contact_time && k > f.partner)) continue;
    f.contact_time = time;
    f.partner = k;
    f.partner_collisions = other.collisions;
  }
}

/// Two spheres exchange Δp = (1 + e)·μ·(v12·n)·n, with the reduced mass μ.
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
  // They part at least so fast that rounding cannot leave them approaching; otherwise spheres that stay together (e = 0)
  // might creep into each other, and three of them collide forever at one moment.
  const double parting = std::max(e * approach, kRounding * (length(a.velocity) + length(b.velocity)));
  const double share = mass(j) / (mass(i) + mass(j));  // μ / m_i
  const V after_i = a.velocity - (share * (approach + parting)) * n;
  const V after_j = b.velocity + ((1 - share) * (approach + parting)) * n;
  count_event(i);
  check(i, after_i);
  check(j, after_j);
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

/// Whether the walls leave sphere i no room along an axis.
template <class V>
bool EventDriven<V>::is_wedged(int i, int axis) const {
  if (rules_.box.is_periodic() || (axis == 1 && rules_.box.boundary == Boundary::open_top)) return false;
  return rules_.box.max[axis] - rules_.box.min[axis] - 2 * radius(i) <= kWedged * radius(i);
}

/// Sphere i is thrown back by a wall; at least so fast that gravity needs the duration of a contact to bring it back. A
/// sphere that bounces no faster lies on the wall: that is no collision after which others would lose no energy. A sphere
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
  flights_[size_t(i)].velocity = velocity;

  if (axis == 1 && side < 0) tally_.floor_impulse += mass(i) * (approach + parting);
  ++flights_[size_t(i)].collisions;
  if (parting > resting) note_collision(i, axes);
  forecast(i);
}

template <class V>
void EventDriven<V>::cross_face(int i) {
  Forecast& f = forecasts_[size_t(i)];
  count_event(i);
  cells_.unlink(i, f.cell);
  if (cells_.is_border(f.cell, f.axis, f.side)) {  // of a periodic domain: on to the other end
    f.cell[f.axis] = f.side > 0 ? 0 : cells_.count()[f.axis] - 1;
    flights_[size_t(i)].position[f.axis] -= f.side * (rules_.box.max[f.axis] - rules_.box.min[f.axis]);
  } else {
    f.cell[f.axis] += f.side;
  }
  cells_.link(i, f.cell);
  // The forecast contact holds, since no velocity has changed; only the spheres ahead are new.
  const BlockPart ahead{f.axis, f.side};
  forecast_faces(i);
  forecast_contacts(i, ahead);
  schedule(i);
}

/// Throws where sphere i may not be where it is, or not have the velocity that an event is about to give it. An event checks
/// before it changes a velocity: until then, the flights are those after the event before.
template <class V>
void EventDriven<V>::check(int i, const V& velocity) const {
  const V& position = flights_[size_t(i)].position;
  if (rules_.box.holds(rules_.box.wrap(position)) && dot(velocity, velocity) < 1e30) return;  // false for NaN
  const Vec3d p = widen(position), v = widen(velocity);
  std::ostringstream what;
  what << "it left the domain: its centre is at (" << p.x << ", " << p.y << ", " << p.z << "), its velocity (" << v.x
       << ", " << v.y << ", " << v.z << ")";
  fail(i, what.str());
}

template <class V>
void EventDriven<V>::fail(int i, const std::string& what, const std::string& more) const {
  std::ostringstream where;
  where << "event " << events_ << " (t = " << epoch_start_ + now_ << " s), sphere " << i;
  throw RunError(where.str(), what, more);
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
