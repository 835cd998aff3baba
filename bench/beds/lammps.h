// SPDX-License-Identifier: MIT
// Steps a bed with LAMMPS (https://www.lammps.org), a widely used program for discrete elements, which is found at run
// time (Debian package lammps, program lmp). It reads the bed from a data file and an input script, runs on one thread,
// and writes its measurements to a log.
//
// The same model: pair_style gran/hooke without tangential force, F = kₙ·δ − m_eff·γₙ·vₙ, where ours is
// F = k·δ − 2ζ·√(k·m_eff)·vₙ. So kₙ = k and γₙ = 2ζ·√(k/m_eff), with m_eff = m/2 for two spheres and m at a wall: the
// walls (fix wall/gran) have their own γₙ. Both keep the damping that pulls at the end of a contact.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bed.h"
#include "measured.h"

namespace ballpit {

struct LammpsOptions {
  double skin = 0.3;    ///< as a fraction of the radius
  bool rotates = true;  ///< fix nve/sphere, as is usual for granular beds; false: fix nve, which is cheaper
  bool newton = false;  ///< off in LAMMPS' granular examples
};

class Lammps {
 public:
  /// `program` is a path, or a name on the PATH. Empty if there is none.
  static std::optional<Lammps> find(const std::string& program);

  const std::string& path() const { return path_; }

  /// "29 Sep 2021 - Update 2"; empty before the first run.
  const std::string& version() const { return version_; }

  /// Writes the bed and its input script into a folder, where run() finds them.
  void prepare(const std::filesystem::path& folder, const Bed& bed, const LammpsOptions& options,
               const Stretch& stretch);

  /// Runs what was prepared there. Throws RunError with the message of LAMMPS if it fails.
  Measured run(const std::filesystem::path& folder);

 private:
  explicit Lammps(std::string path) : path_(std::move(path)) {}

  std::string path_;
  std::string version_;
};

}  // namespace ballpit
