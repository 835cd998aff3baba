// SPDX-License-Identifier: MIT
// A run's frames on their way into a file: the start, every so many steps, and the end.
#pragma once

#include <cstdint>
#include <string>

#include "scene/extended_xyz.h"
#include "world/world.h"

namespace ballpit {

class Trajectory {
 public:
  /// Throws RunError where the file cannot be written, as pass() and finish() do.
  Trajectory(const std::string& path, const Domain& domain, int64_t every)
      : path_(path), file_(path, domain), every_(every) {}

  /// To be called in each state but the last: keeps those that are due.
  void pass(World& world) {
    if (world.steps() % every_ == 0) keep(world);
  }

  /// Adds the present state as the last frame, and puts the file into its place.
  void finish(World& world);

  /// Puts the frames so far into their place, and tells where: "; the 33 frames so far are in run.xyz". Of a run that ended
  /// early. Empty where there are none.
  std::string finish_early();

 private:
  void keep(World& world);

  std::string path_;
  ExtendedXyz file_;
  int64_t every_;
};

}  // namespace ballpit
