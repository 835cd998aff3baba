// SPDX-License-Identifier: MIT
#include "cli/trajectory.h"

#include "core/error.h"

namespace ballpit {

void Trajectory::keep(World& world) { file_.append(world.time(), world.bodies()); }

void Trajectory::finish(World& world) {
  keep(world);
  file_.finish();
}

std::string Trajectory::finish_early() {
  if (file_.frames() == 0) return "";
  const std::string frames =
      file_.frames() == 1 ? "first frame is" : std::to_string(file_.frames()) + " frames so far are";
  try {
    file_.finish();
  } catch (const RunError& error) {
    return "the " + frames + " lost: " + error.what();
  }
  return "the " + frames + " in " + path_;
}

}  // namespace ballpit
