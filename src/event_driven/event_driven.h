// SPDX-License-Identifier: MIT
// Event-driven motion of hard spheres: advances from one event to the next, each at its exact time, without time steps
// (docs/responses.md).
//
//     forecast of each sphere                            queue              the earliest event
//     ┌──────────────────────────────┐
//     │ contact_time, partner ──┐    │
//     │ face_time, axis, side ──┴─min│──▶ tournament ──▶   contact   velocities change, both spheres: new forecasts
//     └──────────────────────────────┘                     wall      velocity changes: new forecast
//        the earliest of all contacts                      crossing  of a cell's face: searches only the cells ahead
//        with spheres around                               void      the partner collided meanwhile: new forecast
//
// The sphere of a pair that was forecast last knew the present flights of both, so its forecast holds the pair's
// contact or an earlier event, and no contact is missed. A sphere stores its state at its own latest event.
//
// Inelastic collisions may come infinitely often in a finite time. The TC model prevents this: a collision that follows
// a sphere's previous one within the duration of a contact, along an axis of that one, loses no energy.
//
// Each event reads about forty different cache lines. Those of the coming events are prefetched, as far ahead as the
// tournament shows (schedule()). A collision among 100 000 spheres then costs 1.7 times as much as one among 1 000,
// instead of 2.8 times.
//
// Cost: O(log n) a collision; 156 to 188 bytes a sphere (flight 64, forecast 48, queue 32 to 64, cells 12). Sources:
// Alder, Wainwright, "Studies in Molecular Dynamics. I. General Method" (1959), doi 10.1063/1.1730376; one event for
// each sphere: Lubachevsky, "How to simulate billiards and similar systems" (1991), doi 10.1016/0021-9991(91)90222-7;
// TC model: Luding, McNamara (1998), doi 10.1007/s100350050017.
#pragma once

#include <functional>

#include "bodies/tally.h"
#include "event_driven/cells.h"
#include "event_driven/tournament.h"

namespace ballpit {

template <class V>
struct EventRules {
  Box<V> box;
  V gravity{};                  ///< [m/s²]
  double restitution = 1;       ///< sphere–sphere
  double wall_restitution = 1;  ///< sphere–wall
  double contact_duration = 0;  ///< [s] collisions that follow sooner lose no energy
};

/// A sphere's next event: a contact, or reaching a face of its cell, which leads to the next cell or is a wall.
struct Forecast {
  double contact_time = kNever;     ///< [s] since the epoch
  int32_t partner = -1;             ///< of the contact
  uint32_t partner_collisions = 0;  ///< of the partner when this was forecast
  double face_time = kNever;        ///< [s] since the epoch
  int8_t axis = 0, side = 0;        ///< of the face: side −1 towards smaller coordinates, +1 towards larger ones
  bool is_wall = false;             ///< of the face
  uint8_t struck = 0;               ///< axes along which collisions have changed its velocity lately; for the TC model
  IVec3 cell{0};
  double last_collision = -kNever;  ///< [s] since the epoch; for the TC model

  double time() const { return std::min(contact_time, face_time); }
};

/// A collision that has happened, for those who compare it with another motion.
struct LoggedCollision {
  double time = 0;                         ///< [s] since the start
  int32_t body = -1, partner = -1;         ///< no partner: a wall
  Vec3d change{0.0}, partner_change{0.0};  ///< [m/s] of their velocities
  Vec3d place{0.0};                        ///< [m] where the surfaces touch
};

template <class V>
class EventDriven {
 public:
  EventDriven(const Scene& scene, const EventRules<V>& rules);

  /// Handles all events up to `time` [s] since the start, or as many as `max_events`; returns false if there are more.
  /// Throws RunError, with sphere, event and time, if a sphere is not finite or outside the domain, or if collisions
  /// follow each other without end; it cannot continue then. Throws Interrupted between two events; it can continue
  /// then.
  bool run_until(double time, int64_t max_events = std::numeric_limits<int64_t>::max());

  /// From now on lists the collisions, or no longer; drops those listed so far.
  void keep_log(bool keeps) {
    keeps_log_ = keeps;
    log_.clear();
  }
  const std::vector<LoggedCollision>& log() const { return log_; }

  /// [s] since the start: the latest event that was handled completely. The state at this time is valid, also after
  /// run_until() has thrown.
  double settled_time() const { return epoch_start_ + settled_; }

  int size() const { return static_cast<int>(flights_.size()); }
  double radius(int i) const { return radii_[radii_.size() == 1 ? 0 : size_t(i)]; }
  double mass(int i) const { return masses_[masses_.size() == 1 ? 0 : size_t(i)]; }
  V position_at(double time, int i) const { return flights_[size_t(i)].position_at(local(time), rules_.gravity); }
  V velocity_at(double time, int i) const { return flights_[size_t(i)].velocity_at(local(time), rules_.gravity); }

  const EventRules<V>& rules() const { return rules_; }
  const Cells<V>& cells() const { return cells_; }
  const IVec3& cell(int i) const { return forecasts_[size_t(i)].cell; }

  const Tally& tally() const { return tally_; }
  int64_t events() const { return events_; }            ///< contacts, walls and crossings
  int64_t predictions() const { return predictions_; }  ///< pairs for which a contact was computed
  int64_t bytes() const;

 private:
  static std::vector<double> per_body(const std::vector<double>& values);
  static double epoch_length(const Scene& scene);
  double local(double time) const { return time - epoch_start_; }

  void next_event();
  void start_epoch();
  void count_event(int i);

  void forecast(int i, BlockPart part = {});
  void forecast_faces(int i);
  void forecast_contacts(int i, BlockPart part);
  bool is_void(const Forecast& f) const { return flights_[size_t(f.partner)].collisions != f.partner_collisions; }

  void collide(int i, int j);
  void hit_wall(int i);
  void cross_face(int i);
  void schedule(int i);
  BlockPart part_of(const Forecast& f) const;
  bool is_in_contact(int i) const { return now_ - forecasts_[size_t(i)].last_collision < rules_.contact_duration; }
  bool is_lossless(int i, uint8_t axes) const { return is_in_contact(i) && (forecasts_[size_t(i)].struck & axes) != 0; }
  void note_collision(int i, uint8_t axes);
  bool is_wedged(int i, int axis) const;

  void check(int i, const V& velocity) const;
  [[noreturn]] void fail(int i, const std::string& what, const std::string& more = "") const;

  EventRules<V> rules_;
  Cells<V> cells_;
  Tournament queue_;
  std::vector<Flight<V>> flights_;
  std::vector<Forecast> forecasts_;
  std::vector<Neighbor> neighbors_;     // of the sphere that is forecast
  std::vector<double> radii_, masses_;  // [m], [kg] one each, or one for all

  double now_ = 0;           // [s] since the epoch
  double settled_ = 0;       // [s] since the epoch: now_ after the latest event
  double epoch_length_ = 1;  // [s]
  double epoch_start_ = 0;   // [s] since the start; a multiple of the length
  int64_t events_ = 0, predictions_ = 0;
  double moment_start_ = 0;  // [s] since the epoch; see kMoment
  int64_t moment_events_ = 0;
  Tally tally_;
  bool keeps_log_ = false;
  std::vector<LoggedCollision> log_;
};

}  // namespace ballpit
