// SPDX-License-Identifier: MIT
// Makes a film: numbered frames at equal intervals of time, in a folder. For `ballpit render` and the window's export.
//
//     while (!film.is_done()) { film.advance(…); draw; film.push(…); }    then finish()
#pragma once

#include <functional>
#include <string>

#include "export/frame_sequence.h"
#include "show/demo.h"

namespace ballpit {

struct FilmPlan {
  std::string folder;
  std::string key = {};         ///< see film_key.h
  int first = 0;                ///< frame that this run makes first
  int frames = 0;               ///< in all
  double from = 0;              ///< [s] of the world's time: frame 0
  double interval = 1.0 / 60;   ///< [s] from one frame to the next
  bool keeps_timeline = false;  ///< so that one can go back in time afterwards
};

class Film {
 public:
  /// Makes the folder. Throws RunError if that fails. `demo` must outlive the film.
  Film(Demo& demo, const FilmPlan& plan) : demo_(demo), plan_(plan), frames_(plan.folder, plan.first, plan.key) {}

  bool is_done() const { return next() >= plan_.frames; }
  int next() const { return frames_.next_index(); }  ///< the number of the frame that the next push takes
  const FilmPlan& plan() const { return plan_; }

  /// Steps to the state of the next frame, or until stop() is true; returns whether it is there. Throws RunError as
  /// World::step() does.
  bool advance(const std::function<bool()>& stop);

  /// Whether the world is already beyond the next frame.
  bool is_overtaken() const;

  /// See FrameSequence.
  void push(Image frame) { frames_.push(std::move(frame)); }
  void finish() { frames_.finish(); }

 private:
  Demo& demo_;
  FilmPlan plan_;
  FrameSequence frames_;
};

}  // namespace ballpit
