// SPDX-License-Identifier: MIT
// Steps a bed with both programs from the same start, in turns: ours, LAMMPS, ours, LAMMPS, … so that other load on the
// machine slows both. Either may be left out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bed.h"
#include "lammps.h"
#include "measure/statistics.h"
#include "measured.h"

namespace ballpit {

struct BedProtocol {
  int repeat = 5;
  Stretch stretch;
  BedClock clock = BedClock::wall;
  bool runs_ours = true;
  Settings settings;  ///< ours
  LammpsOptions lammps;
};

/// All turns of one program on one bed.
struct Turns {
  std::vector<double> speed;  ///< million particle-steps a second
  Measured last;
};

struct BedRow {
  std::string bed;
  int64_t count = 0;
  double fraction = 0;  ///< of the volume up to the highest sphere's centre, at the start
  std::optional<Turns> ours, theirs;

  bool has_both() const { return ours && theirs; }
  /// Ours over theirs, turn by turn: above 1, ours is faster. Needs both.
  Spread ratio() const;
  /// Of the kinetic energies at the end, as a fraction of theirs. Needs both.
  double energy_difference() const;
};

/// `folder` holds LAMMPS' files.
BedRow compare_bed(const Bed& bed, std::optional<Lammps>& lammps, const BedProtocol& protocol,
                   const std::filesystem::path& folder);

}  // namespace ballpit
