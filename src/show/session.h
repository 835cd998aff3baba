// SPDX-License-Identifier: MIT
// A session holds what a demonstration is made of: a scene, the world that steps it, and how it is looked at.
// The window and the headless renderer are its only two loops.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "methods/settings.h"
#include "render/frame_view.h"
#include "scene/scene.h"
#include "show/given_options.h"
#include "show/view.h"
#include "world/world.h"

namespace ballpit {

class Session {
 public:
  /// Loads a scene and makes its world. Options given override the scene's [defaults], which override the
  /// program's. The world keeps a tally of collisions where it is told to. Throws UserError for anything that is not
  /// allowed.
  Session(std::string_view scene, const std::vector<GivenOption>& given, bool keeps_tally = false);

  /// Takes a shared option anew, or gives it back to the program where `value` is empty: detection changes in the same world; with any other
  /// option, a new world goes on from the present state; count and seed fill the scene again. Options that do not go with another response are dropped.
  /// Throws UserError where it is not allowed; then nothing has changed.
  void set(const std::string& name, const std::string& value);

  /// The same for what the scene file says.
  void set_physics(const Physics& physics);

  /// These options and physics, and no others: a new world goes on from the present state. Throws as set().
  void take(const std::vector<GivenOption>& given, const Physics& physics) { go_on(given, physics); }

  /// From the scene's start, or another scene's; options given stay, where they go with it.
  void restart() { load(scene_name_); }
  void load(const std::string& scene);

  double time() const { return time_before_ + world_->time(); }  ///< [s] since the scene's start

  /// Steps until the state nearest to `time` [s], or until stop() is true. Throws RunError as World::step()
  /// does.
  template <class Stop>
  void advance_to(double time, Stop&& stop) {
    while (steps_until(time) > 0 && !stop()) world_->step();
  }

  /// Steps from here to the state nearest to `time`; 0 if it is reached. Throws UserError for more than can
  /// be counted.
  int64_t steps_until(double time) const;

  /// The present state for the renderer; `inspection` must outlive what is returned.
  FrameView view_of(const Inspection& inspection, const View& view, float aspect) const;

  const Scene& scene() const { return scene_; }
  const std::string& scene_name() const { return scene_name_; }     ///< as it was loaded: of a file, its path
  const std::vector<GivenOption>& given() const { return given_; }  ///< options that override the scene's
  const Settings& settings() const { return settings_; }
  const std::string& backend() const { return backend_; }  ///< "cpu", also where settings ask for auto
  World& world() { return *world_; }
  const World& world() const { return *world_; }

 private:
  void start(std::string scene, std::vector<GivenOption> given);
  bool detect_by(const std::vector<GivenOption>& given);
  void go_on(std::vector<GivenOption> given, const Physics& physics);
  void use(Scene scene, const Settings& settings);

  std::string scene_name_;  // or a file
  std::vector<GivenOption> given_;
  bool keeps_tally_;
  double time_before_ = 0;  // [s] that earlier worlds covered
  Scene scene_;
  Settings settings_;
  std::string backend_;
  std::unique_ptr<World> world_;
};

/// Writes the last good state of a run that failed to `path`, and tells so: "; the last good state, of t = 0.32 s, is in FILE". Where
/// that fails too, as it may where a device or a disk did, it tells why.
std::string rescue(Session& session, const std::string& path);

}  // namespace ballpit
