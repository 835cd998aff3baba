// SPDX-License-Identifier: MIT
#include "world/exact_motion.h"

#include <cmath>
#include <iterator>
#include <map>

namespace ballpit {

namespace {

constexpr int64_t kMaxBytes = int64_t(64) << 20;  // of copies
constexpr size_t kMaxCopies = 32;
constexpr int64_t kEventsPerSphere = 4;  // from one copy to the next at first: a copy then costs 2 % of these events

template <class V>
class ExactMotionOf final : public ExactMotion {
 public:
  ExactMotionOf(const Scene& scene, const Settings& settings)
      : motion_(scene, {.box = {narrow<V>(scene.domain.min), narrow<V>(scene.domain.max), scene.domain.boundary},
                        .gravity = narrow<V>(scene.physics.gravity),
                        .restitution = scene.physics.restitution,
                        .wall_restitution = scene.physics.wall_restitution,
                        .contact_duration = settings.contact_duration}),
        interval_(kEventsPerSphere * (motion_.size() + 1)) {
    copies_.emplace(0.0, motion_);
  }

  bool go_to(double time, int64_t max_events, std::vector<LoggedCollision>* log) override {
    if (time < now_ || is_torn_) {
      const auto& [then, copy] = *std::prev(copies_.upper_bound(std::max(time, 0.0)));
      motion_ = copy;
      now_ = then;
    }
    is_torn_ = true;
    if (log) motion_.keep_log(true);
    const bool has_arrived = motion_.run_until(time, max_events);
    if (log) {
      *log = motion_.log();
      motion_.keep_log(false);
    }
    if (!has_arrived) return false;
    is_torn_ = false;
    now_ = time;
    if (motion_.events() - std::prev(copies_.end())->second.events() >= interval_) keep_copy();
    return true;
  }

  double now() const override { return now_; }

  void lead(const Bodies& stepped, Lead& result) const override {
    const auto n = size_t(motion_.size());
    result.position.resize(n);
    result.velocity.resize(n);
    double sum = 0;
    for (size_t i = 0; i < n; ++i) {
      const V velocity = motion_.velocity_at(now_, int(i));
      const V there = narrow<V>(stepped.position[i]);
      result.position[i] = widen(motion_.rules().box.displacement(motion_.position_at(now_, int(i)), there));
      result.velocity[i] = stepped.velocity[i] - widen(velocity);
      sum += dot(velocity, velocity);
    }
    result.exact_speed = n > 0 ? std::sqrt(sum / double(n)) : 0;
  }

  Vec3d displacement(const Vec3d& from, const Vec3d& to) const override {
    return widen(motion_.rules().box.displacement(narrow<V>(from), narrow<V>(to)));
  }

  int64_t collisions() const override { return motion_.tally().collisions; }
  int64_t events() const override { return motion_.events(); }

 private:
  void keep_copy() {
    copies_.emplace_hint(copies_.end(), now_, motion_);
    while (copies_.size() > kMaxCopies ||
           (int64_t(copies_.size()) * motion_.bytes() > kMaxBytes && copies_.size() > 1)) {
      interval_ *= 2;
      for (auto copy = std::next(copies_.begin()); copy != copies_.end();) {
        copy = copies_.erase(copy);
        if (copy != copies_.end()) ++copy;
      }
    }
  }

  EventDriven<V> motion_;
  double now_ = 0;                           // [s]
  bool is_torn_ = false;                     // it has stopped between now_ and where it was to go
  std::map<double, EventDriven<V>> copies_;  // by their times [s]; the first is that of the start
  int64_t interval_;                         // events from one copy to the next
};

}  // namespace

std::unique_ptr<ExactMotion> make_exact_motion(const Scene& scene, const Settings& settings) {
  if (scene.domain.dimensions == 2) return std::make_unique<ExactMotionOf<Vec2d>>(scene, settings);
  return std::make_unique<ExactMotionOf<Vec3d>>(scene, settings);
}

}  // namespace ballpit
