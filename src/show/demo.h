// SPDX-License-Identifier: MIT
// A demonstration as it is operated: a session, how it is played and looked at, and what panel, keys and mouse do to them.
// A user's mistake becomes a message; the demonstration goes on as it was.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "show/keys.h"
#include "show/player.h"
#include "show/session.h"
#include "show/timeline.h"
#include "show/trade_off.h"
#include "show/view.h"

namespace ballpit {

/// How exact the run was at a step.
struct Moment {
  int64_t step = 0;
  float energy_drift = 0;  ///< of the energy at the start of this world; 0 where that is 0
  float max_overlap = 0;   ///< of the smaller radius
};

class Demo {
 public:
  /// Throws UserError as Session does.
  Demo(std::string_view scene, const std::vector<GivenOption>& given);

  Session session;
  Player player;
  std::unique_ptr<Timeline> timeline;  ///< of the session's world
  TradeOff trade_off;                  ///< of the settings that were played in this scene
  View view;

  /// What a key does, but for saving a picture, which whoever draws it does.
  void perform(const Key& key);

  void set(const std::string& option, const std::string& value);
  void set_physics(const Physics& physics);
  void return_to(const Played& trial);  ///< its settings
  void load(const std::string& scene);
  void restart();
  void step();
  void step_back() { go_to(timeline->step_now() - 1); }

  /// To an earlier moment of this world, or forward again, by the same bits; pauses.
  void go_to(int64_t step);

  /// As the clock goes on by `elapsed` [s]; see Player::advance().
  void advance(double elapsed, double share) { player.advance(*timeline, elapsed, share); }

  /// A line for the audience; the latest.
  const std::string& message() const { return message_; }
  void say(const std::string& message) { message_ = message; }

  bool shows_keys = false;

  /// The present state, and what the view shows beside; looked at once.
  const Inspection& inspection() { return look(wanted() | Wanted{}); }
  const Report& report();

  /// The present state and view for the renderer, until either changes. Where the bodies are written already, they are looked
  /// at only for who needs them.
  FrameView frame_view(float aspect, bool is_written = false);

  /// Whether the inspection was to hold candidates, and they were not too many.
  bool has_candidates() const { return looked_for_.candidates && !left_out_.candidates; }

  /// The latest reported steps up to the present one, oldest first.
  const std::vector<Moment>& history() const { return history_; }

  /// How many timelines there were; a change of anything but the detection makes another world, whose time begins at 0.
  int64_t worlds() const { return worlds_; }

  /// Changes whenever anything that is shown may have: a window that has drawn this need not draw again.
  int64_t version() const { return (version_ << 36) + session.world().steps(); }
  void touch() { ++version_; }

 private:
  /// Does what may be a user's mistake.
  void attempt(const std::function<void()>& action);
  void begin_anew();
  const Inspection& look(Wanted wanted);
  void remember_moment();
  Wanted wanted();
  Wanted too_much(const Wanted& wanted);
  int64_t candidates_to_list();

  std::string message_;
  double energy_at_start_ = 0;  // [J] kinetic, potential and elastic
  int64_t version_ = 0, worlds_ = 0;
  int64_t looked_at_ = -1, reported_ = -1;
  Inspection inspection_;
  Wanted looked_for_, left_out_;
  Report report_;
  std::vector<Moment> history_;
};

}  // namespace ballpit
