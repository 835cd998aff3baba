// SPDX-License-Identifier: MIT
// Trajectories as extended XYZ, which OVITO and ASE read: frames one behind the other, each a line with the number of
// spheres, a line of keys, and one sphere a line. Columns have the names that OVITO maps by itself: pos, radius, velo, mass
// (OVITO user manual, "XYZ file reader").
//
//     2000
//     Lattice="6 0 0 0 4 0 0 0 4" Origin="0 0 0" Properties=species:S:1:pos:R:3:… Time=0.5 pbc="F F F"
//     X 0.1 0.2 0.3 0.05 1 0 0 0.5
//     …
//
// Cost: O(spheres) a frame, about 150 bytes each, through a buffer of a megabyte. Numbers are the shortest that read back
// as the same double.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/file.h"
#include "scene/scene.h"

namespace ballpit {

class ExtendedXyz {
 public:
  /// Begins a trajectory beside its place. Throws RunError naming the path and the system's reason, as append() and finish()
  /// do.
  ExtendedXyz(const std::filesystem::path& path, const Domain& domain);

  /// What ends without finish() leaves its whole frames in place as well; an error is then lost.
  ~ExtendedXyz();
  ExtendedXyz(const ExtendedXyz&) = delete;
  ExtendedXyz& operator=(const ExtendedXyz&) = delete;

  /// Appends the state of `time` [s]. Where that fails, the frames before it can still be finished.
  void append(double time, const Bodies& bodies);

  /// Puts the whole frames into their place; no file where there are none. Nothing may be appended after it.
  void finish();

  int64_t frames() const { return frames_; }  ///< whole ones

 private:
  void append_header(double time, const Bodies& bodies);
  void flush();

  Domain domain_;
  std::optional<NewFile> file_;
  std::string buffer_;
  int64_t written_ = 0;  // bytes in the file
  int64_t whole_ = 0;    // bytes of whole frames
  int64_t frames_ = 0;
};

}  // namespace ballpit
