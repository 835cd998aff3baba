// SPDX-License-Identifier: MIT
// Writes trajectories as extended XYZ, which OVITO and ASE read (OVITO user manual, "XYZ file reader"): a sequence of frames.
//
//     2000
//     Lattice="6 0 0 0 4 0 0 0 4" Origin="0 0 0" Properties=species:S:1:pos:R:3:… Time=0.5 pbc="F F F"
//     X 0.1 0.2 0.3 0.05 1 0 0 0.5
//     …
//
// Cost: O(spheres) per frame, about 150 bytes for each. Numbers are the shortest that read back as the same double.
#pragma once

#include "core/file.h"
#include "scene/scene.h"

namespace ballpit {

class ExtendedXyz {
 public:
  /// Begins a trajectory in a temporary file. Throws RunError naming path and reason, as append() and finish() do.
  ExtendedXyz(const std::filesystem::path& path, const Domain& domain);

  /// Finishes the file if finish() was not called, and ignores errors.
  ~ExtendedXyz();
  ExtendedXyz(const ExtendedXyz&) = delete;
  ExtendedXyz& operator=(const ExtendedXyz&) = delete;

  /// Appends the state at `time` [s]. If it fails, finish() still writes the earlier frames. `note` is printable text
  /// without quotes, which becomes a key of its own.
  void append(double time, const Bodies& bodies, std::string_view note = "");

  /// Gives the file its name; makes no file without frames. Do not append after it.
  void finish();

  int64_t frames() const { return frames_; }  ///< complete ones

 private:
  void append_header(double time, const Bodies& bodies, std::string_view note);
  void flush();

  Domain domain_;
  std::optional<NewFile> file_;
  std::string buffer_;
  int64_t written_ = 0;  // bytes in the file
  int64_t whole_ = 0;    // bytes of complete frames
  int64_t frames_ = 0;
};

}  // namespace ballpit
