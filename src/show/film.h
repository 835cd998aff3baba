// SPDX-License-Identifier: MIT
// Makes a film: numbered frames at equal intervals of time, in a folder. For `ballpit render` and the window's export.
//
//     while (!film.is_done()) { film.advance(…); draw; film.frames.push(…); }    then frames.finish()
//
// Each frame holds a key: a text that describes the pictures, so that --resume continues only the same film.
//
//     size 640x360
//     scene lecture-grid
//     …                      one line for each thing that affects the pictures, its name first
#pragma once

#include <functional>
#include <string>

#include "export/frame_sequence.h"
#include "show/demo.h"

namespace ballpit {

struct FilmPlan {
  std::string folder;
  std::string key = {};         ///< see film_key()
  int first = 0;                ///< frame that this run makes first
  int frames = 0;               ///< in all
  double from = 0;              ///< [s] of the world's time: frame 0
  double interval = 1.0 / 60;   ///< [s] from one frame to the next
  bool keeps_timeline = false;  ///< so that one can go back in time afterwards
};

class Film {
 public:
  /// Makes the folder. Throws RunError if that fails. `demo` must outlive the film.
  Film(Demo& demo, const FilmPlan& all) : plan(all), frames(all.folder, all.first, all.key), demo_(demo) {}

  const FilmPlan plan;
  FrameSequence frames;

  int next() const { return frames.next_index(); }  ///< the number of the frame that the next push takes
  bool is_done() const { return next() >= plan.frames; }

  /// Steps to the state of the next frame, or until stop() is true; returns whether it is there. Throws RunError as
  /// World::step() does.
  bool advance(const std::function<bool()>& stop);

  /// Whether the world is already beyond the next frame.
  bool is_overtaken() const;

 private:
  Demo& demo_;
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
