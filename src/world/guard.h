// SPDX-License-Identifier: MIT
// Stops a run that has gone wrong. Every step: a sphere that is not finite or outside the domain. Every kSteps-th step: an
// overlap or an energy beyond its limit. A state that passes is stored as the last good one.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "methods/settings.h"
#include "scene/scene.h"
#include "world/body_store.h"
#include "world/sums.h"

namespace ballpit {

/// Predicate: pair k overlaps by about `limit` of the smaller radius, or more.
template <class V>
struct MayOverlapTooMuch {
  using Real = Scalar<V>;
  BodiesView<V> bodies;
  Box<V> box;
  Span<const Pair> pairs;
  Real limit;

  HOST_DEVICE bool operator()(int k) const {
    const Pair pair = pairs[k];
    const V d = box.displacement(bodies.position[pair.i], bodies.position[pair.j]);
    const Real ri = bodies.radius[pair.i], rj = bodies.radius[pair.j];
    const Real reach = (ri + rj - limit * (ri < rj ? ri : rj)) * Real(1.00001);  // rounding must not hide an overlap
    return !((reach <= 0) | (dot(d, d) > reach * reach));
  }
};

/// Map: the energy that body i may have without a cause [J].
template <class V>
struct LeastEnergy {
  BodiesView<V> bodies;
  double gravity;  ///< [m/s²]
  double rounded;  ///< [J/kg]
  HOST_DEVICE double operator()(int i) const {
    return (gravity * double(bodies.radius[i]) + rounded) / double(bodies.inverse_mass[i]);
  }
};

/// What helps against overlap: where springs are resolved by the steps, only stiffer ones do.
inline std::string overlap_hint(const Scene& scene, const Settings& settings) {
  constexpr const char* kSmallerSteps = "a smaller --dt or more --substeps may help";
  constexpr double kResolved = 0.5;  // of √(m/k): well below the 0.71 at which packings become unstable
  if (settings.response != Response::penalty || scene.bodies.size() == 0) return kSmallerSteps;
  const double radius = *std::min_element(scene.bodies.radius.begin(), scene.bodies.radius.end());
  const double mass = *std::min_element(scene.bodies.mass.begin(), scene.bodies.mass.end());
  // Hertz's springs grow stiffer with overlap: at the largest that is allowed.
  const double stiffness =
      scene.physics.stiffness *
      (scene.physics.law == "hertz" ? 1.5 * std::sqrt(std::fmin(settings.max_overlap, 1.0) * radius) : 1.0);
  const bool is_resolved = settings.dt / settings.substeps < kResolved * std::sqrt(mass / stiffness);
  if (!is_resolved || integrator_of(settings) == Integrator::explicit_euler) return kSmallerSteps;
  return "a larger [physics] stiffness may help (and the smaller --dt that it needs)";
}

template <class V, class Exec>
class Guard {
  using Buffer = typename Exec::template Buffer<V>;

 public:
  /// What the checks compare with, and the time of the last good state.
  struct Values {
    double max_overlap, overlap_at_start = 0;   ///< of the smaller radius
    double energy_at_start = 0, explained = 0;  ///< [J] --max-energy is a multiple of `explained`
    double good_time = 0;                       ///< [s]
  };

  /// What a snapshot holds of the guard. Where the last good state is the present one, it is held once, by the bodies.
  struct Saved {
    Values values;
    bool is_present_good = false;
    std::vector<V> good_position, good_velocity;
  };

  /// `h` [s]: length of a substep. `hint`: what helps against too much overlap, and against spheres that leave.
  Guard(double max_overlap, double max_energy, double h, std::string hint)
      : values_{max_overlap}, max_energy_(max_energy), h_(h), hint_(std::move(hint)) {}

  /// Call before the first step, at `time` [s]. `near` are pairs that include all contacts; `elastic` is the energy in springs [J].
  /// `more` is what the motion keeps for each body, or null; it belongs to the state.
  void start(const BodyStore<V, Exec>& bodies, Span<const Pair> near, double elastic, double time, const Buffer* more) {
    values_.overlap_at_start = largest_overlap(bodies.exec(), "check overlap", bodies.view(), bodies.box(), near);
    values_.max_overlap = std::fmax(values_.max_overlap, 2 * overlap_at_start());  // overlap at the start may settle
    values_.energy_at_start = energy(bodies) + elastic;
    values_.explained = std::fmax(values_.energy_at_start, least_energy(bodies));
    keep(bodies, time, more);
  }

  bool is_started() const { return good_position_.size() > 0; }
  double overlap_at_start() const { return values_.overlap_at_start; }  ///< of the smaller radius

  /// Whether check() is to be called after this step.
  static bool is_due(int64_t step) { return step % kSteps == 0; }

  /// Throws RunError where a body is not a number, or outside the domain; halts the device instead while it defers.
  void check_inside(const BodyStore<V, Exec>& bodies, int64_t step, double time) const {
    if (!stops_if(bodies.exec(), "check bodies", bodies.count(), IsOutside<V>{bodies.view(), bodies.box()})) return;
    const std::vector<V> position = bodies.downloaded(bodies.position), velocity = bodies.downloaded(bodies.velocity);
    const IsOutside<V> is_outside{{{position.data(), bodies.count()}, {velocity.data(), bodies.count()}, {}, {}},
                                  bodies.box()};
    int bad = 0;
    while (!is_outside(bad)) ++bad;
    const Vec3d p = widen(position[static_cast<size_t>(bad)]);
    stop(step, time, hint_, "sphere ", bad, " left the domain: its centre is at (", p.x, ", ", p.y, ", ", p.z, ")");
  }

  /// Throws RunError where overlap or energy are beyond their limits; else the state is the last good one. `near` and `more`: as
  /// above.
  void check(const BodyStore<V, Exec>& bodies, Span<const Pair> near, int64_t step, double time, const Buffer* more) {
    check_overlap(bodies, near, step, time);
    check_energy(bodies, step, time);
    keep(bodies, time, more);
  }

  Bodies last_good(const BodyStore<V, Exec>& bodies) const { return bodies.download(good_position_, good_velocity_); }
  double last_good_time() const { return values_.good_time; }  ///< [s]

  /// Makes the last good state the present one; where the executor defers, and since the last start or check.
  void go_back(BodyStore<V, Exec>& bodies, Buffer* more) const {
    copy(bodies.exec(), "go back", good_position_, bodies.position);
    copy(bodies.exec(), "go back", good_velocity_, bodies.velocity);
    if (more != nullptr) copy(bodies.exec(), "go back", good_more_, *more);
  }

  /// The last good state, by slot.
  std::array<Buffer*, 3> kept() { return {&good_position_, &good_velocity_, &good_more_}; }

  /// The guard of `bodies` at `time` [s].
  Saved save(const BodyStore<V, Exec>& bodies, double time) const {
    if (is_started() && values_.good_time == time) return {values_, true, {}, {}};
    return {values_, false, bodies.exec().download(good_position_.span()),
            bodies.exec().download(good_velocity_.span())};
  }

  /// `bodies` are those of the snapshot.
  void restore(const BodyStore<V, Exec>& bodies, const Saved& saved) {
    values_ = saved.values;
    if (saved.is_present_good) {
      keep(bodies, saved.values.good_time);
    } else {
      bodies.exec().upload(good_position_, saved.good_position);
      bodies.exec().upload(good_velocity_, saved.good_velocity);
    }
  }

  int64_t bytes() const { return good_position_.bytes() + good_velocity_.bytes() + good_more_.bytes(); }

 private:
  static constexpr int64_t kSteps = 16;

  template <class... Parts>
  [[noreturn]] static void stop(int64_t step, double time, const std::string& hint, const Parts&... what) {
    throw RunError(streamed("step ", step, " (t = ", time, " s)"), streamed(what...), hint);
  }

  static double wall_overlap(const BodyStore<V, Exec>& state) {
    if (state.box().is_periodic()) return 0;
    const WallOverlap<V> overlap{state.view(), state.box()};
    return reduce(state.exec(), "check overlap", state.count(), 0.0, overlap, Largest{});
  }

  /// Finds the largest overlap on the host, since the run ends with it.
  void check_overlap(const BodyStore<V, Exec>& state, Span<const Pair> near, int64_t step, double time) const {
    const MayOverlapTooMuch<V> of_pair{state.view(), state.box(), near, static_cast<Scalar<V>>(values_.max_overlap)};
    if (!any(state.exec(), "check overlap", near.size(), of_pair) && wall_overlap(state) <= values_.max_overlap) return;
    const auto saved = state.save();
    const BodiesView<V> bodies = saved.view();
    double worst = values_.max_overlap;
    int first = -1, second = -1;  // slots; second −1: a wall
    const auto compare = [&](double overlap, int i, int j) {
      if (overlap > worst) std::tie(worst, first, second) = std::tuple(overlap, i, j);
    };
    for (const Pair& pair : state.exec().download(near)) {
      compare(PairOverlap<V>{bodies, state.box(), {&pair, 1}}(0), pair.i, pair.j);
    }
    for (int i = 0; i < state.count(); ++i) compare(WallOverlap<V>{bodies, state.box()}(i), i, -1);
    if (first < 0) return;
    stop(step, time, hint_, "sphere ", saved.id(first), " overlaps ",
         second < 0 ? "a wall" : streamed("sphere ", saved.id(second)), " by ", worst,
         " of the smaller radius, more than --max-overlap ", values_.max_overlap);
  }

  /// Springs are left out: spurious energy does not stay in them.
  void check_energy(const BodyStore<V, Exec>& state, int64_t step, double time) const {
    if (state.box().is_periodic() && state.has_gravity()) return;  // falls forever
    const double now = energy(state), start = values_.energy_at_start;
    if (now <= max_energy_ * values_.explained) return;
    const Bodies bodies = state.download();
    const auto kinetic = [&](size_t i) { return 0.5 * bodies.mass[i] * dot(bodies.velocity[i], bodies.velocity[i]); };
    size_t fastest = 0;
    for (size_t i = 1; i < bodies.mass.size(); ++i) fastest = kinetic(i) > kinetic(fastest) ? i : fastest;
    stop(step, time,
         overlap_at_start() > kOverlapThatMatters ? "less overlap at the start may help"
                                                  : "a smaller --dt or more --substeps may help",
         "the energy is ",
         start > 0 ? streamed(now / start, " times that at the start") : streamed(now, " J, and was 0 J at the start"),
         ", more than --max-energy ", max_energy_, "; sphere ", fastest, " has most of it, ", kinetic(fastest), " J");
  }

  /// [J] The energy that any run may have: from lifting spheres by their radius, as out of the floor, and from rounding.
  double least_energy(const BodyStore<V, Exec>& state) const {
    const V extent = state.box().max - state.box().min, g = state.gravity();
    const double speed = 64 * double(std::numeric_limits<Scalar<V>>::epsilon()) * length(widen(extent)) / h_;
    return reduce(state.exec(), "check energy", state.count(), 0.0,
                  LeastEnergy<V>{state.view(), length(widen(g)), 0.5 * speed * speed}, Sum{});
  }

  /// [J] kinetic, and potential above the lowest corner of the domain.
  static double energy(const BodyStore<V, Exec>& state) {
    const V lowest = glm::mix(state.box().max, state.box().min, glm::lessThan(state.gravity(), V(0)));
    const EnergyAndMomentum sum = reduce(state.exec(), "check energy", state.count(), EnergyAndMomentum{},
                                         EnergyAndMomentumOf<V>{state.view(), state.gravity(), lowest}, Sum{});
    return sum.kinetic + sum.potential;
  }

  void keep(const BodyStore<V, Exec>& state, double time, const Buffer* more = nullptr) {
    copy(state.exec(), "keep state", state.position, good_position_);
    copy(state.exec(), "keep state", state.velocity, good_velocity_);
    if (Exec::kDefers && more != nullptr) copy(state.exec(), "keep state", *more, good_more_);
    values_.good_time = time;
  }

  static void copy(Exec& exec, const char* name, const Buffer& from, Buffer& to) {
    to.resize(from.size());
    exec.parallel_for(name, from.size(), CopyValues<V>{from.span(), to.span()});
  }

  static constexpr double kOverlapThatMatters = 0.001;  // of the smaller radius

  Values values_;
  double max_energy_, h_;
  std::string hint_;
  Buffer good_position_, good_velocity_, good_more_;
};

}  // namespace ballpit
