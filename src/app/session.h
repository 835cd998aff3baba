// SPDX-License-Identifier: MIT
// A session holds what a demonstration is made of: a scene, the world that steps it, and how it is looked at.
// The window and the headless renderer are its only two loops.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/given_options.h"
#include "render/frame_view.h"
#include "scene/scene.h"
#include "simulate/settings.h"
#include "simulate/world.h"

namespace ballpit {

class Session {
 public:
  /// Loads a scene and makes its world. Options given override the scene's [defaults], which override the
  /// program's. The world keeps a tally of collisions where it is told to. Throws UserError for anything that is not
  /// allowed.
  Session(std::string_view scene, const std::vector<GivenOption>& given, bool keeps_tally = false);

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
  FrameView view_of(const Inspection& inspection, float aspect, const std::vector<std::string>& overlays) const;

  const Scene& scene() const { return scene_; }
  const Settings& settings() const { return settings_; }
  const std::string& backend() const { return backend_; }  ///< "cpu", also where settings ask for auto
  World& world() { return *world_; }

 private:
  Scene scene_;
  Settings settings_;
  std::string backend_;
  std::unique_ptr<World> world_;
};

}  // namespace ballpit
