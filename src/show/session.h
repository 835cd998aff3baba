// SPDX-License-Identifier: MIT
// A session: a scene, the settings, and the world that simulates it; and the choice of the processor that it runs on.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "choose/record.h"
#include "choose/watch.h"
#include "show/options.h"
#include "world/acts.h"

namespace ballpit {

/// The backend of this name. Automatic: CUDA if there is a device and the response runs on it, else the CPU. Throws
/// UserError with the reason if the backend is not available.
Backend select_backend(BackendName name, Response response = Response::impulse);

class Session {
 public:
  /// Loads a scene and makes its world. Options given override the scene's [defaults], which override the program's
  /// defaults. `keeps_tally`: the world counts collisions. Throws UserError for anything that is not allowed.
  /// `kept` is what an earlier run with --response auto has chosen; empty: it is chosen here.
  Session(std::string_view scene, const std::vector<GivenOption>& given, bool keeps_tally = false,
          const std::filesystem::path& kept = {});

  /// Sets an option, or resets it to the default if `value` is empty. Options of the detection change in the same
  /// world. With any other option a new world goes on from the present state; count, seed and mass-ratio start the
  /// scene again. A new response drops the options that do not fit it. Throws UserError if the value is not allowed;
  /// then nothing changes.
  void set(const std::string& name, const std::string& value);

  /// Replaces all options and the physics. A new world goes on from the present state. Throws as set().
  void take(std::vector<GivenOption> given, const Physics& physics);

  /// Starts the scene again, with the same options, or another scene, with the same backend and threads.
  void load(const std::string& scene);

  /// The run has these acts from now on, which are in order of time; call at its start. A restart repeats them.
  void play(std::vector<Act> acts);

  /// What was done to the spheres, and is to be done. A timeline steps by it.
  Acts& acts() { return acts_; }
  const Acts& acts() const { return acts_; }

  /// Call after an act that a timeline has added.
  void acted();

  /// [s] when settings or physics were last changed in this run, so that a run by the present ones is another; empty if
  /// they were not.
  std::optional<double> changed_at() const { return changed_at_; }

  double time() const { return world_->time(); }  ///< [s] since the scene's start

  /// Steps until the state nearest to `time` [s], or until stop() is true. With --response auto the run may go back in time
  /// before it is there, and on with other settings; it calls `went_back` then. Throws as World::step() does, and RunError
  /// if no settings are left that hold what the scene needs.
  void advance_to(double time, const std::function<bool()>& stop, const std::function<void()>& went_back = {});

  /// Steps from here to the state nearest to `time`. Throws UserError for too many to be counted.
  int64_t steps_until(double time) const;

  const Scene& scene() const { return scene_; }
  const std::string& scene_name() const { return scene_name_; }     ///< name, or path of a file
  const std::vector<GivenOption>& given() const { return given_; }  ///< options that override the scene's
  const Settings& settings() const { return settings_; }
  const std::string& backend() const { return backend_; }  ///< in use: never "auto"

  /// What --response auto has chosen; null without it.
  const Choice* choice() const { return choice_ ? &*choice_ : nullptr; }

  /// A change of settings while --response auto runs.
  struct StepUp {
    double time;         ///< [s] to which the run went back
    std::string reason;  ///< what was broken, and when
    Settings settings;   ///< from then on
  };
  const std::vector<StepUp>& steps_up() const { return steps_up_; }
  World& world() { return *world_; }
  const World& world() const { return *world_; }

  /// Whether reports have the times of the stages also on a GPU, where each time costs some.
  void time_stages(bool is_timed) {
    times_stages_ = is_timed;
    world_->time_stages(is_timed);
  }

  /// Of the world's present state; made once for each step. Steps and seconds are those of the whole run, also where
  /// --response auto has changed the settings.
  const Report& report();

 private:
  void start(std::string scene, std::vector<GivenOption> given, const std::filesystem::path& kept = {});
  bool detect_by(const std::vector<GivenOption>& given);
  void use(Scene scene, const Settings& settings);
  void go_on_with(Scene scene, const Settings& settings, double time);
  Settings resolve(const Scene& scene, const std::vector<GivenOption>& given);
  void step_up(const std::string& reason);
  void end_watch();

  std::string scene_name_;
  std::vector<GivenOption> given_;
  bool keeps_tally_, times_stages_ = false;
  double start_time_ = 0;  // [s] at which the present world began
  Scene scene_;
  Settings settings_;
  std::string backend_;
  std::unique_ptr<World> world_;
  std::optional<Report> report_;  // the last one of this world, after
  int64_t reported_ = 0;          // steps of it
  std::optional<Choice> choice_;
  std::optional<Watch> watch_;
  Acts acts_;
  std::vector<Act> script_;  // acts that a restart repeats
  std::optional<double> changed_at_;
  std::vector<StepUp> steps_up_;
  int64_t steps_before_ = 0;   // of worlds before these changes
  double seconds_before_ = 0;  // [s] of computing, of the same
};

/// Writes the last good state of a run that failed to `path`. Returns "the last good state, of t = 0.32 s, is in FILE",
/// or why it could not be written.
std::string rescue(Session& session, const std::string& path);

}  // namespace ballpit
