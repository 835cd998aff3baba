// SPDX-License-Identifier: MIT
// Makes a film: frames at equal intervals of time, as numbered pictures in a folder, as an MP4 file, or both. For
// `ballpit render` and the window's export.
//
//     while (!film.is_done()) { film.advance(…); draw; film.push(…); }    then film.finish()
//
// Each picture holds a key: a text that describes the pictures, so that --resume continues only the same film.
//
//     size 640x360
//     scene lecture-grid
//     …                      one line for each thing that affects the pictures, its name first
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "export/film_file.h"
#include "export/frame_sequence.h"
#include "show/demo.h"

namespace ballpit {

/// [1/s] A faster film would play on few screens; it becomes slow motion.
constexpr double kMaxFilmRate = 60;

struct FilmPlan {
  std::string folder;           ///< of the pictures; empty for none
  std::string key = {};         ///< see film_key()
  int first = 0;                ///< frame that this run makes first
  int frames = 0;               ///< in all
  double from = 0;              ///< [s] of the world's time: frame 0
  double interval = 1.0 / 60;   ///< [s] from one frame to the next
  bool keeps_timeline = false;  ///< so that one can go back in time afterwards
  std::string file = {};        ///< MP4; empty for none
  PictureSize size = {};        ///< of the film in the file

  /// [1/s] at which the file plays: in real time, if that is possible.
  double rate() const { return std::min(1 / interval, kMaxFilmRate); }
};

class Film {
 public:
  /// Makes the folder and begins the file. Throws RunError if that fails. `demo` must outlive the film.
  Film(Demo& demo, const FilmPlan& all);

  const FilmPlan plan;

  int next() const { return next_; }  ///< the number of the frame that the next push takes
  bool is_done() const { return next() >= plan.frames; }

  /// Steps to the state of the next frame, or until stop() is true; returns whether it is there. Throws RunError as
  /// World::step() does.
  bool advance(const std::function<bool()>& stop);

  /// Adds the next frame. Throws as FrameSequence::push() and FilmFile::push() do.
  void push(Image frame);

  /// Completes the pictures, and the file if the film is done. Throws as FrameSequence and FilmFile do.
  void finish();

  /// Whether the world is already beyond the next frame.
  bool is_overtaken() const;

 private:
  Demo& demo_;
  int next_;
  std::optional<FrameSequence> frames_;
  std::optional<FilmFile> file_;
};

/// The settings of a film that are neither in its plan nor in the demonstration.
struct FilmLook {
  PictureSize size;
  int supersample = 1;
  bool has_panel = false;
  std::string clicks = {};  ///< on the panel
};

/// The key of a film that begins with the present state. It leaves out options that change no picture: threads,
/// backend, limits that stop a run.
std::string film_key(Demo& demo, const FilmPlan& plan, const FilmLook& look);

/// Throws UserError if one of the first `count` frames in a folder has another key, or, without a key, another size.
void check_frames(const std::string& folder, int count, const std::string& key);

}  // namespace ballpit
