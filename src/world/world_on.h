// SPDX-License-Identifier: MIT
// The world, written once for every executor, number of dimensions and precision: its parts, what it shows of itself, and its
// snapshots. Instantiated for each vector type by worlds_cpu.cpp and cuda/worlds_cuda_*.cu.
#pragma once

#include "world/deferred_steps.h"
#include "world/inspect_more.h"
#include "world/make_world.h"
#include "world/occluders.h"

namespace ballpit {

/// A snapshot of a world by its parts. In single precision and space it takes 28 bytes a sphere, or 52 where the guard's last
/// good state is another one, and 12 more where velocity Verlet keeps accelerations.
template <class V, class Exec>
struct SnapshotOn final : Snapshot {
  int64_t steps = 0, edition = 0;
  typename BodyStore<V, Exec>::Saved bodies;
  typename Motion<V, Exec>::Saved motion;
  typename TallyKeeper<V, Exec>::Saved tally;
  typename Guard<V, Exec>::Saved guard;

  int64_t bytes() const override {
    const auto size = [](const auto&... values) { return int64_t((0 + ... + (values.size() * sizeof(values[0])))); };
    return int64_t(sizeof(*this)) + size(bodies.position, bodies.velocity, bodies.radius, bodies.inverse_mass,
                                         bodies.order, motion.acceleration, tally.before, tally.found,
                                         guard.good_position, guard.good_velocity);
  }
};

template <class V, class Exec>
class WorldOn final : public World {
  using Real = Scalar<V>;

 public:
  WorldOn(std::unique_ptr<Exec> exec, const Scene& scene, const Settings& settings)
      : settings_(settings),
        scene_(scene),
        world_{BodyStore<V, Exec>(std::move(exec), scene),
               {},
               make_motion<V, Exec>(scene, settings),
               TallyKeeper<V, Exec>(settings.keeps_tally, settings.is_swept),
               make_guard(scene)} {
    scene_.bodies = {};
    world_.collider = make_collider(settings);
  }

  void step() override {
    const Stopwatch stopwatch(seconds_);
    if constexpr (Exec::kDefers) {
      if (bodies_.exec().seems_halted()) repeat_steps();
      if (deferred_.may_defer(world_, steps_ + 1)) {
        ++steps_;
        bodies_.exec().defer([&] { make_present_step(); });
        return;
      }
      finish_steps();
    }
    make_exact_step();
  }

  void wait() override {
    const Stopwatch stopwatch(seconds_);
    finish_steps();
  }

  void time_stages(bool is_timed) override {
    if constexpr (Exec::kDefers) bodies_.exec().time_stages(is_timed);
  }

  Inspection inspect(const Wanted& wanted) override {
    wait();
    Exec& exec = bodies_.exec();
    Inspection result;
    result.bodies.count = bodies_.count();
    result.bodies.dimensions = kDimensions<V>;
    if (!wanted.state) return result;
    result.bodies.position = flat(bodies_.downloaded(bodies_.position));
    result.bodies.velocity = flat(bodies_.downloaded(bodies_.velocity));
    const std::vector<Real> radius = bodies_.radii();
    result.bodies.radius.assign(radius.begin(), radius.end());
    result.contacts = exec.download(pairs());
    result.grids =
        std::visit([&](auto& method) { return method.inspect(exec); }, world_.collider.prepared(exec, bodies_.view()));
    if (wanted.more_than_state()) inspect_more(bodies_, world_.collider, wanted, result);
    const std::vector<int> id_at = exec.download(bodies_.order().id_at());
    if (!id_at.empty()) name_by_id(result, id_at);
    if (wanted.occluders && kDimensions<V> == 3) {
      typename Exec::template Buffer<Occluders> occluders;
      occluders.resize(bodies_.count());
      find_occluders(occluders.span());
      result.bodies.occluders = exec.download(occluders.span());
    }
    return result;
  }

  Report report() override {
    wait();
    Exec& exec = bodies_.exec();
    const BodiesView<V> bodies = bodies_.view();
    Report report;
    report.contacts = pairs().size();
    report.broadphase = name_of(world_.collider.choice().method);
    report.broadphase_reason = world_.collider.choice().reason;
    report.count = bodies_.count();
    report.steps = steps_;
    report.time = time();
    report.seconds = seconds_;
    report.candidates = world_.collider.tests(exec);
    report.searches = world_.collider.searches();
    report.detection_bytes = world_.collider.bytes();
    report.body_bytes = bodies_.bytes();
    report.motion_bytes = world_.motion->bytes() + world_.guard.bytes() + world_.tally.bytes();
    const EnergyAndMomentum motion = reduce(exec, "sum motion", bodies.size(), EnergyAndMomentum{},
                                            EnergyAndMomentumOf<V>{bodies, bodies_.gravity()}, Sum{});
    report.kinetic_energy = motion.kinetic;
    report.potential_energy = motion.potential;
    report.momentum = motion.momentum;
    report.elastic_energy = world_.motion->elastic_energy(bodies_, pairs());
    report.max_overlap = largest_overlap(exec, "largest overlap", bodies, bodies_.box(), pairs());
    report.state_hash =
        reduce(exec, "hash state", bodies_.count(), uint64_t(0), HashOfBody<V>{bodies, bodies_.order().id_at()}, Sum{});
    report.tally = world_.tally.tally();
    report.stages = exec.stage_times().stages();
    return report;
  }

  bool detect_by(const Settings& settings) override {
    wait();
    auto collider = make_collider(settings);
    collider.pairs(bodies_.exec(),
                   bodies_.view());  // what is impossible, or lacks memory, throws before anything has changed
    collider.discard();
    world_.collider = std::move(collider);
    settings_ = settings;
    bodies_.exec().stage_times().clear();
    return true;
  }

  BodyShape shape() const override { return bodies_.shape(); }
  void write_bodies(const BodyTarget& target) override {
    wait();
    ballpit::write_bodies(bodies_, pairs(), target);
    if (!target.occluders.empty()) find_occluders(target.occluders);
  }

  Bodies bodies() override {
    wait();
    return bodies_.download();
  }
  Bodies last_good() override { return world_.guard.is_started() ? world_.guard.last_good(bodies_) : bodies(); }
  double last_good_time() override { return world_.guard.last_good_time(); }

  /// Collisions go on being counted: a contact of before is not a new one.
  void replace(const Bodies& bodies) override {
    wait();
    Exec& exec = bodies_.exec();
    std::array<std::vector<V>, 2> before;
    for (size_t k = 0; k < before.size(); ++k) before[k] = bodies_.downloaded(*world_.tally.kept()[k]);
    bodies_.replace(bodies);
    begin_edition(++editions_, bodies);
    for (size_t k = 0; k < before.size(); ++k) {
      for (size_t i = before[k].size(); i > 0 && i < bodies.position.size(); ++i) {
        before[k].push_back(narrow<V>(bodies.position[i]));
      }
      exec.upload(*world_.tally.kept()[k], before[k]);
    }
  }

  std::unique_ptr<Snapshot> snapshot() override {
    wait();
    auto result = std::make_unique<SnapshotOn<V, Exec>>();
    result->steps = steps_;
    result->edition = edition_;
    result->bodies = bodies_.save();
    result->motion = world_.motion->save(bodies_.exec());
    result->tally = world_.tally.save(bodies_.exec());
    result->guard = world_.guard.save(bodies_, time());
    return result;
  }

  /// Contacts and candidate lists are not in a snapshot: they are found again, and the same.
  void restore(const Snapshot& snapshot) override {
    const auto& saved = dynamic_cast<const SnapshotOn<V, Exec>&>(snapshot);
    if constexpr (Exec::kDefers) {
      if (bodies_.exec().has_halted()) bodies_.exec().go_on();
    }
    deferred_.forget();
    steps_ = saved.steps;
    bodies_.restore(saved.bodies);
    if (saved.edition != edition_) begin_edition(saved.edition, bodies_.download());
    world_.motion->restore(bodies_.exec(), saved.motion);
    world_.tally.restore(bodies_.exec(), saved.tally);
    world_.guard.restore(bodies_, saved.guard);
    world_.collider.discard();
  }

  int64_t steps() const override { return steps_; }
  double time() const override { return start_time_ + static_cast<double>(steps_) * settings_.dt; }

  void go_on_from(double time, const Tally& tally) override {
    start_time_ = time;
    world_.tally.go_on_from(tally);
  }

 private:
  Real substep() const { return static_cast<Real>(settings_.dt / settings_.substeps); }

  /// Number steps_.
  void make_present_step() { make_step(world_, steps_, time(), settings_.substeps, substep()); }

  /// The next step, whole: what it counts and checks is known at its end.
  void make_exact_step() {
    if (!world_.guard.is_started()) {
      start(world_, time(), substep());
      deferred_.note_good(world_, steps_);
    }
    ++steps_;
    make_present_step();
    if (world_.guard.is_due(steps_)) deferred_.note_good(world_, steps_);
  }

  void finish_steps() {
    if constexpr (Exec::kDefers) {
      if (bodies_.exec().has_halted()) repeat_steps();
    }
  }

  /// The device has halted: makes the steps since the last good state again.
  void repeat_steps() {
    const int64_t goal = steps_;
    steps_ = deferred_.go_back(world_);
    while (steps_ < goal) make_exact_step();
  }

  /// Makes the parts that depend on the bodies which now are in bodies_.
  void begin_edition(int64_t edition, const Bodies& bodies) {
    scene_.bodies = bodies;
    world_.motion = make_motion<V, Exec>(scene_, settings_);
    world_.guard = make_guard(scene_);
    deferred_.forget();
    scene_.bodies = {};
    world_.collider = make_collider(settings_);
    edition_ = edition;
  }

  Guard<V, Exec> make_guard(const Scene& scene) const {
    return {settings_.max_overlap, settings_.max_energy, settings_.dt / settings_.substeps,
            overlap_hint(scene, settings_)};
  }

  Collider<V, Exec> make_collider(const Settings& settings) const {
    const std::vector<Real> radius = bodies_.radii();
    const Span<const Real> span(radius.data(), static_cast<int64_t>(radius.size()));
    auto parameters = broad_phase_parameters<V>(settings, bodies_.box(), span, bodies_.count());
    for (SizeClass<V>& spheres : parameters.classes) spheres.largest += world_.motion->margin();
    return {settings, parameters};
  }

  void find_occluders(Span<Occluders> occluders) {
    occluders_.find(
        bodies_.exec(), bodies_.view(), bodies_.box(), [&] { return bodies_.radii(); }, bodies_.order().id_at(),
        occluders);
  }

  /// The pairs in contact at the present positions.
  Span<const Pair> pairs() { return world_.collider.pairs(bodies_.exec(), bodies_.view()); }

  static std::vector<float> flat(const std::vector<V>& values) {
    std::vector<float> result;
    result.reserve(values.size() * kDimensions<V>);
    for (const V& value : values) {
      for (int axis = 0; axis < kDimensions<V>; ++axis) result.push_back(static_cast<float>(value[axis]));
    }
    return result;
  }

  Settings settings_;
  Scene scene_;  // its bodies are in world_
  WorldParts<V, Exec> world_;
  BodyStore<V, Exec>& bodies_ = world_.bodies;
  OccluderSearch<V, Exec> occluders_;
  DeferredSteps<V, Exec> deferred_;
  int64_t steps_ = 0;
  int64_t edition_ = 0, editions_ = 0;   // of the bodies: another one with each replace()
  double start_time_ = 0, seconds_ = 0;  // [s]
};

template <class V, class Exec>
std::unique_ptr<World> make_world_of(std::unique_ptr<Exec> exec, const Scene& scene, const Settings& settings) {
  return std::make_unique<WorldOn<V, Exec>>(std::move(exec), scene, settings);
}

}  // namespace ballpit
