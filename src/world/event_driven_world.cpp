// SPDX-License-Identifier: MIT
// The world of the event-driven response.
#include <chrono>

#include "core/error.h"
#include "event_driven/event_driven.h"
#include "world/body_store.h"
#include "world/instances_cpu.h"
#include "world/make_world.h"
#include "world/sums.h"

namespace ballpit {

namespace {

constexpr const char* kTooFast = "collisions follow each other so fast that a step takes too long";
constexpr double kTouching = 1e-9;  // of the smaller radius: a gap that counts as a contact

template <class V>
class EventDrivenWorld final : public World {
 public:
  EventDrivenWorld(const Scene& scene, const Settings& settings)
      : dt_(settings.dt), patience_(settings.patience), scene_(scene), motion_(scene, rules(scene, settings)) {
    scene_.bodies = {};  // the motion has them
  }

  void step() override {
    const auto start = std::chrono::steady_clock::now();
    const auto takes_too_long = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > patience_;
    };
    const double end = static_cast<double>(steps_ + 1) * dt_;
    constexpr int64_t kEvents = 10'000;
    try {
      while (!motion_.run_until(end - began_, kEvents)) {
        if (takes_too_long()) throw RunError(streamed("t = ", start_time_ + settled_time(), " s"), kTooFast);
      }
    } catch (...) {
      time_ = std::max(time_, settled_time());
      throw;
    }
    ++steps_;
    time_ = end;
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  Inspection inspect(const Wanted& wanted) override {
    Inspection result;
    result.bodies.count = motion_.size();
    result.bodies.dimensions = kDimensions<V>;
    if (!wanted.state) return result;
    for (int i = 0; i < motion_.size(); ++i) {
      const V p = position(i), v = velocity(i);
      for (int axis = 0; axis < kDimensions<V>; ++axis) {
        result.bodies.position.push_back(static_cast<float>(p[axis]));
        result.bodies.velocity.push_back(static_cast<float>(v[axis]));
      }
      result.bodies.radius.push_back(static_cast<float>(motion_.radius(i)));
    }
    for (const auto& [pair, gap] : contacts()) result.contacts.push_back(pair);
    result.grids.push_back(grid());
    if (wanted.candidates) result.candidates = pairs_in_reach();
    if (wanted.occluders && kDimensions<V> == 3) {
      result.bodies.occluders.resize(static_cast<size_t>(motion_.size()));
      find_occluders({result.bodies.occluders.data(), motion_.size()});
    }
    return result;
  }

  Report report() override {
    Report report;
    report.count = motion_.size();
    report.steps = steps_;
    report.time = time();
    report.seconds = seconds_;
    report.stages = {{"handle events", seconds_, steps_}};
    report.broadphase = "event cells";
    report.broadphase_reason = "event-driven motion searches cells of its own";
    report.detection_bytes = motion_.bytes();
    report.candidates = motion_.predictions();
    report.events = events_before_ + motion_.events();
    report.tally = tally_before_ + motion_.tally();
    for (const auto& [pair, gap] : contacts()) {
      ++report.contacts;
      report.max_overlap = std::max(report.max_overlap, -gap / smaller_radius(pair));
    }
    measure_bodies(report);
    return report;
  }

  BodyShape shape() const override {
    float largest = 0, smallest = INFINITY;
    for (int i = 0; i < motion_.size(); ++i) {
      largest = std::max(largest, static_cast<float>(motion_.radius(i)));
      smallest = std::min(smallest, static_cast<float>(motion_.radius(i)));
    }
    return {motion_.size(), kDimensions<V>, false, largest, smallest};
  }

  void write_bodies(const BodyTarget& target) override {
    for (int i = 0; i < motion_.size(); ++i) {
      write_body(target, i, position(i), motion_.radius(i));
      target.touching[i] = 0;
    }
    for (const auto& [pair, gap] : contacts()) target.touching[pair.i] = target.touching[pair.j] = 1;
    if (!target.occluders.empty()) find_occluders(target.occluders);
  }

  Bodies bodies() override {
    Bodies result;
    for (int i = 0; i < motion_.size(); ++i) {
      result.position.push_back(widen(position(i)));
      result.velocity.push_back(widen(velocity(i)));
      result.radius.push_back(motion_.radius(i));
      result.mass.push_back(motion_.mass(i));
    }
    return result;
  }

  /// All events are forecast anew.
  void replace(const Bodies& bodies) override {
    scene_.bodies = bodies;
    EventDriven<V> motion(scene_, motion_.rules());
    scene_.bodies = {};
    tally_before_ = tally_before_ + motion_.tally();
    events_before_ += motion_.events();
    motion_ = std::move(motion);
    began_ = time_;
  }

  std::unique_ptr<Snapshot> snapshot() override { return std::make_unique<EventSnapshot>(*this); }
  void restore(const Snapshot& snapshot) override {
    const auto& then = dynamic_cast<const EventSnapshot&>(snapshot);
    motion_ = then.motion;
    steps_ = then.steps;
    time_ = then.time;
    began_ = then.began;
    events_before_ = then.events_before;
    tally_before_ = then.tally_before;
  }

  int64_t steps() const override { return steps_; }
  double time() const override { return start_time_ + time_; }

  void go_on_from(double time, const Tally& tally) override {
    start_time_ = time;
    tally_before_ = tally;
  }

 private:
  /// The whole motion with forecasts and queue, since the latest event of each sphere determines later bits.
  struct EventSnapshot final : Snapshot {
    explicit EventSnapshot(const EventDrivenWorld& world)
        : motion(world.motion_),
          steps(world.steps_),
          events_before(world.events_before_),
          time(world.time_),
          began(world.began_),
          tally_before(world.tally_before_) {}
    int64_t bytes() const override { return motion.bytes() + int64_t(sizeof(*this)); }

    EventDriven<V> motion;
    int64_t steps, events_before;
    double time, began;
    Tally tally_before;
  };

  static EventRules<V> rules(const Scene& scene, const Settings& settings) {
    return {.box = {narrow<V>(scene.domain.min), narrow<V>(scene.domain.max), scene.domain.boundary},
            .gravity = narrow<V>(scene.physics.gravity),
            .restitution = scene.physics.restitution,
            .wall_restitution = scene.physics.wall_restitution,
            .contact_duration = settings.contact_duration};
  }

  double settled_time() const { return began_ + motion_.settled_time(); }
  V unwrapped(int i) const { return motion_.position_at(time_ - began_, i); }
  V position(int i) const { return motion_.rules().box.wrap(unwrapped(i)); }
  V velocity(int i) const { return motion_.velocity_at(time_ - began_, i); }

  double smaller_radius(const Pair& pair) const { return std::min(motion_.radius(pair.i), motion_.radius(pair.j)); }

  /// Calls visit(pair, neighbor) for all spheres in neighbouring cells, for each image that is near.
  template <class Visit>
  void for_each_neighbor(const Visit& visit) const {
    std::vector<Neighbor> neighbors;
    for (int i = 0; i < motion_.size(); ++i) {
      motion_.cells().gather(motion_.cell(i), {}, neighbors);
      for (const Neighbor& neighbor : neighbors) {
        if (neighbor.body > i) visit(Pair{i, neighbor.body}, neighbor);
      }
    }
  }

  /// The pairs of spheres that touch, by i, then j, and their gaps [m].
  std::vector<std::pair<Pair, double>> contacts() const {
    std::vector<std::pair<Pair, double>> contacts;
    for_each_neighbor([&](const Pair& pair, const Neighbor& neighbor) {
      const V p = unwrapped(pair.i), other = unwrapped(pair.j);
      const double radii = motion_.radius(pair.i) + motion_.radius(pair.j);
      const double gap = length(other + motion_.cells().shift(neighbor) - p) - radii;
      if (gap <= kTouching * smaller_radius(pair)) contacts.emplace_back(pair, gap);
    });
    std::sort(contacts.begin(), contacts.end());
    return contacts;
  }

  /// All pairs of spheres in neighbouring cells, by i, then j; each once, even if several images meet.
  std::vector<Pair> pairs_in_reach() const {
    std::vector<Pair> pairs;
    for_each_neighbor([&](const Pair& pair, const Neighbor&) { pairs.push_back(pair); });
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  /// Energy, momentum, overlap with walls and the hash of the present state.
  void measure_bodies(Report& report) const {
    EnergyAndMomentum sum;
    for (int i = 0; i < motion_.size(); ++i) {
      const V p = position(i), v = velocity(i);
      const double radius = motion_.radius(i), inverse_mass = 1 / motion_.mass(i);
      const BodiesView<V> body{{&p, 1}, {&v, 1}, {&radius, 0}, {&inverse_mass, 0}};
      sum = sum + EnergyAndMomentumOf<V>{body, motion_.rules().gravity}(0);
      report.max_overlap = std::max(report.max_overlap, WallOverlap<V>{body, motion_.rules().box}(0));
      report.state_hash += hash_body(i, p, v);
    }
    report.kinetic_energy = sum.kinetic;
    report.potential_energy = sum.potential;
    report.momentum = sum.momentum;
  }

  void find_occluders(Span<Occluders> occluders) {
    std::vector<Vec3> place;
    std::vector<float> radius;
    for (int i = 0; i < motion_.size(); ++i) {
      place.emplace_back(widen(position(i)));
      radius.push_back(static_cast<float>(motion_.radius(i)));
    }
    const Box<V>& box = motion_.rules().box;
    const BodiesView<Vec3> bodies{{place.data(), motion_.size()}, {}, {radius.data(), 1}, {}};
    occluders_.find(
        exec_, bodies, {Vec3(widen(box.min)), Vec3(widen(box.max)), box.boundary}, [&] { return radius; }, {},
        occluders);
  }

  GridInspection grid() const {
    const Cells<V>& cells = motion_.cells();
    GridInspection result;
    result.origin = Vec3(widen(motion_.rules().box.min));
    result.edge = Vec3(widen(cells.edge()));
    result.cells = cells.count();
    result.head = cells.head();
    result.next = cells.next();
    return result;
  }

  double dt_, patience_;  // [s]
  Scene scene_;           // without bodies
  EventDriven<V> motion_;
  int64_t steps_ = 0, events_before_ = 0;
  double time_ = 0;   // [s] since its own start: the end of the last step, or the moment at which it stopped
  double began_ = 0;  // [s] when the present motion began, at an act or at the start
  double start_time_ = 0, seconds_ = 0;  // [s]
  Tally tally_before_;
  CpuExecutor exec_{1};
  OccluderSearch<Vec3, CpuExecutor> occluders_;
};

}  // namespace

std::unique_ptr<World> make_event_driven_world(const Scene& scene, const Settings& settings) {
  if (scene.domain.dimensions == 2) return std::make_unique<EventDrivenWorld<Vec2d>>(scene, settings);
  return std::make_unique<EventDrivenWorld<Vec3d>>(scene, settings);
}

}  // namespace ballpit
