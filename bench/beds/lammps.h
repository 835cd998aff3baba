// SPDX-License-Identifier: MIT
// A bed stepped by LAMMPS (https://www.lammps.org), the program that users of discrete elements compare with, found at
// run time: Debian's package lammps, program lmp. It gets the bed as a data file and an input script of its own kind,
// runs alone on one thread, and tells what it measured in its log.
//
// The same model: pair_style gran/hooke without tangential force, F = kₙ·δ − m_eff·γₙ·vₙ, where ours is
// F = k·δ − 2ζ·√(k·m_eff)·vₙ. So kₙ = k and γₙ = 2ζ·√(k/m_eff), with m_eff = m/2 for two spheres and m at a wall: the
// walls (fix wall/gran) have their own γₙ. Damping that pulls at the end of a contact is left in by both.
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
  bool newton = false;  ///< newton off is what LAMMPS' granular examples have
};

class Lammps {
 public:
  /// `program` as typed: a path, or a name to be found on PATH. Empty where there is none.
  static std::optional<Lammps> find(const std::string& program);

  const std::string& path() const { return path_; }

  /// "29 Sep 2021 - Update 2"; empty before the first run.
  const std::string& version() const { return version_; }

  /// Writes the bed and its input script into a folder, where run() finds them.
  void prepare(const std::filesystem::path& folder, const Bed& bed, const LammpsOptions& options,
               const Stretch& stretch);

  /// Steps what was prepared there. Throws RunError with LAMMPS' own words where it fails.
  Measured run(const std::filesystem::path& folder);

 private:
  explicit Lammps(std::string path) : path_(std::move(path)) {}

  std::string path_;
  std::string version_;
};

}  // namespace ballpit
