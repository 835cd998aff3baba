// SPDX-License-Identifier: MIT
// Writes a film as one MP4 file (H.264), by ffmpeg, which reads the frames from a pipe. ffmpeg is no part of the program: it
// runs if it is on the PATH. The file gets its name when it is complete; until then it is FILE.mp4.part.
//
//     push() ──RGBA──▶ pipe ──▶ ffmpeg ──H.264──▶ film.mp4.part ──rename──▶ film.mp4
//
// Cost: ffmpeg codes in a process of its own, some 10 ms a frame of 1280 × 720, while the next frame is drawn.
#pragma once

#include <filesystem>
#include <string>

#include "core/file.h"
#include "core/program.h"
#include "render/image.h"

namespace ballpit {

class FilmFile {
 public:
  /// `rate`: frames a second. Throws RunError naming the file.
  FilmFile(const std::filesystem::path& path, int width, int height, double rate);

  /// Appends a frame of the film's size. Throws RunError with ffmpeg's reason if it has failed, and Interrupted.
  void push(const Image& frame);

  /// Completes the file. Throws as push() does. Without it, no file is left.
  void finish();

 private:
  [[noreturn]] void fail(const ProgramResult& result) const;

  std::filesystem::path path_;
  NewFile file_;
  PipedProgram ffmpeg_;
};

/// Throws the error that writing a film there would throw, as far as it is known before: UserError if ffmpeg is missing or
/// the name does not end in .mp4, RunError if the file cannot be written. `option` is named by the UserError.
void check_film_file(std::string_view option, const std::filesystem::path& path);

}  // namespace ballpit
