// SPDX-License-Identifier: MIT
// A demonstration: a session, a player, a view, and the actions of panel, keys and mouse. A mistake of the user becomes
// a message, and the demonstration goes on as before.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/page_view.h"
#include "show/background_choice.h"
#include "show/session.h"
#include "show/timeline.h"
#include "show/trade_off.h"
#include "show/view.h"
#include "world/ghost.h"

namespace ballpit {

/// The accuracy of the run at a step.
struct Moment {
  int64_t step = 0;
  float energy_drift = 0;  ///< as a fraction of the energy when this world began, or after an act since; 0 if that is 0
  float max_overlap = 0;   ///< of the smaller radius
};

class Demo;
struct OverlayEntry;  // render/overlays/overlay.h

/// A key of a demonstration, for the window, the list that F1 shows, and the README.
struct Key {
  int code;               ///< as GLFW has it: the ASCII code of letters and digits
  std::string_view name;  ///< as it is printed: "Space"
  std::string_view help;
  void (*act)(Demo&);
};

std::span<const Key> key_table();

class Demo {
 public:
  /// Throws UserError as Session does.
  Demo(std::string_view scene, const std::vector<GivenOption>& given, const std::filesystem::path& kept = {});
  Demo(const Demo&) = delete;
  Demo& operator=(const Demo&) = delete;

  Session session;
  Player player;
  std::unique_ptr<Timeline> timeline;  ///< of the session's world
  TradeOff trade_off;                  ///< of the settings that were played in this scene
  View view;

  void perform(const Key& key) {
    touch();
    key.act(*this);
  }

  void set(const std::string& option, const std::string& value);
  void set_physics(const Physics& physics);
  void return_to(const Played& trial);  ///< to its settings
  void load(const std::string& scene);
  void restart();
  void step();
  /// Throws as Session does.
  void play(const std::vector<Act>& acts);

  /// Acts on the spheres now. What was ahead is forgotten, the ghost too; a run that has failed may go on.
  void act(const Act& act);

  void step_back() { go_to(timeline->step_now() - 1); }

  /// Begins to choose the cheapest settings with which the scene shows what it needs, from the present state. The scene
  /// goes on; once the choice is made, advance() goes on with its settings, or with those before if none hold. A second
  /// call gives it up, and so does a change of settings, physics or scene.
  void choose_cheapest();
  bool is_choosing() const { return background_.is_running(); }
  void finish_choosing() { take_choice(background_.wait()); }  ///< waits for the choice, for pictures without a window

  /// The latest choice for this scene, or that of --response auto; null if there is none.
  const Choice* choice() const { return choice_ ? &*choice_ : session.choice(); }

  /// Begins exact motion from the present state, beside this one, and shows it.
  void drop_ghost();

  /// Call after each step that the timeline does not make. Costs nothing while the ghost is hidden.
  void follow();

  /// Pauses and goes to an earlier step of this world, or forward again, with bit-identical states.
  void go_to(int64_t step);

  /// Plays for `elapsed` [s]; see Player::advance().
  void advance(double elapsed, double share) {
    take_choice(background_.result());
    player.advance(*timeline, elapsed, share);
  }

  /// Shows the scene by several broad phases side by side: here by the first of them, and in a demonstration beside
  /// this one by each other, which does from now on what this one does. Call before the first step. Throws UserError if
  /// the scene or its response has no use for them.
  void compare(const std::vector<BroadPhase>& methods);
  bool is_comparing() const { return !beside_.empty(); }

  /// The views of the picture: this demonstration, or one for each method that is compared.
  size_t view_count() const { return 1 + beside_.size(); }
  Demo& view_at(size_t k) { return k == 0 ? *this : *beside_[k - 1]; }

  std::vector<std::string> compared_methods() const;  ///< their names

  /// Where they are in a picture of this aspect.
  std::vector<Room> rooms(float aspect);

  /// The title over all views of a comparison.
  FrameView heading();

  /// Takes those beside this one to its step, and gives them its view.
  void keep_together();

  /// Pairs tested so far by the searches of all steps, one in each; of a method that is compared.
  int64_t tests_so_far();

  bool measures = false;  ///< whether captions of a comparison have measured times; films must be repeatable

  /// Steps to `time` [s] as Session::advance_to() does.
  void advance_to(double time, const std::function<bool()>& stop);

  /// The latest line for the audience.
  const std::string& message() const { return message_; }
  void say(const std::string& message) { message_ = message; }

  bool shows_keys = false;

  std::optional<Aim> aim;  ///< an act that the mouse prepares

  /// The present state with what the view shows. Inspects the world once for each version().
  const Inspection& inspection(bool with_occluders = false) {
    return inspect(wanted() | Wanted{.occluders = with_occluders});
  }
  const Report& report();

  /// The present state and view for the renderer, valid until either changes. If the bodies are already written to the
  /// renderer's buffer, they are copied only for overlays that need them.
  /// `share`: the view's height [of the picture's].
  FrameView frame_view(float aspect, bool is_written = false, bool with_occluders = false, float share = 1);

  /// Whether a picture of this height [pixel] has ambient occlusion: not in the plane, nor where spheres are too small to
  /// show it.
  bool shows_occlusion(int height = 1080) const;

  double writing_time = 0;  ///< [s] that the last picture took to find the occluders and to write the spheres; 0: none

  /// Why an overlay has nothing to draw, in any view; "" if it has, or if it is not shown.
  std::string lack_of(const OverlayEntry& overlay);

  /// Whether the inspection holds candidates: they were wanted, and there were not too many.
  bool has_candidates() const { return requested_.candidates && !left_out_.candidates; }

  /// The latest reported steps, oldest first, up to the present one.
  const std::vector<Moment>& history() const { return history_; }

  /// The number of worlds so far. Every change except of the detection makes a new world, whose time begins at 0.
  int64_t worlds() const { return worlds_; }

  /// Two equal versions look the same, so that a window need not draw the second one.
  struct Version {
    int64_t changes = -1, steps = -1;
    bool operator==(const Version&) const = default;
  };
  Version version() const { return {changes_, session.world().steps()}; }
  void touch() { ++changes_; }

 private:
  /// Runs an action and turns its error into a message.
  void attempt(const std::function<void()>& action);
  void change(const std::function<void()>& action);  // the same for one that makes a new world
  void begin_world();
  std::vector<GivenOption> kept_by_choice() const;
  std::vector<GivenOption> options_by(const Choice& choice) const;
  void predict(const Choice& choice);
  void take_choice(std::optional<BackgroundChoice::Result> result);
  void forget_choice();
  void begin_ghost();
  int64_t acts_so_far() const { return session.acts().count_until(session.time()); }
  bool shows_ghost() const { return view.shows("ghost"); }
  bool go_on_to(int64_t step, const std::function<bool()>& stop);
  const Inspection& inspect(Wanted wanted);
  void remember_moment(const Report& report);
  PageView captioned();
  PageView compared();
  std::string title() const;
  DomainBox box() const;
  void each_beside(const std::function<void(Demo&)>& action);
  void load_compared(const std::string& scene);
  void catch_up(int64_t step);
  void count_tests();
  void forget_tests();
  Wanted wanted();
  Wanted too_much(const Wanted& wanted);
  int64_t candidates_to_list();

  std::string message_;
  double energy_at_start_ = 0;                                      // [J] kinetic, potential and elastic
  int64_t acts_at_start_ = 0, reported_acts_ = 0, ghost_acts_ = 0;  // so far, at that time
  int64_t changes_ = 0, worlds_ = 0;
  Version inspected_, reported_;
  Inspection inspection_;
  PageView caption_, heading_;
  Wanted requested_, left_out_;
  std::vector<Moment> history_;
  std::unique_ptr<Ghost> ghost_;  // once it is shown
  BackgroundChoice background_;
  std::optional<Choice> choice_;
  std::vector<GivenOption> chosen_;  // options of the session that a choice has set

  std::vector<std::unique_ptr<Demo>> beside_;  // of a comparison
  std::optional<BroadPhase> compared_;         // the method of this view of a comparison
  std::vector<int64_t> tests_;                 // so far, at each step of the timeline from its first on
  int64_t changes_shown_ = -1;                 // those of the view that the others have
  Inspection nothing_;                         // for pictures without spheres
};

}  // namespace ballpit
