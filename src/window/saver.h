// SPDX-License-Identifier: MIT
// Saves pictures, states and films of a running demonstration, under the first free names in the current folder. The
// demonstration's message reports what was saved, or why not. Needs the OpenGL context that pictures are drawn in.
#pragma once

#include <memory>

#include "show/demo_renderer.h"
#include "show/film.h"

namespace ballpit {

class Saver {
 public:
  /// `demo` must outlive the saver.
  explicit Saver(Demo& demo) : demo_(demo) {}

  /// The scene without the panel, each pixel averaged from 2 × 2.
  void save_picture(PictureSize size);

  /// In the format of `ballpit simulate --out`.
  void save_state();

  /// What was done to the spheres, for --acts, with the command that makes the run again.
  void save_acts();

  /// Pauses, and makes frames of the present world from now on, sixty a simulated second, as `ballpit render` draws
  /// them: one with each advance(). The folder holds the acts too, if there are any.
  void start_film(PictureSize size, int frames);
  void advance();
  void stop_film();
  bool is_filming() const { return film_ != nullptr; }

 private:
  template <class Action>
  void attempt(const Action& action);

  Demo& demo_;
  std::unique_ptr<Film> film_;
  std::unique_ptr<DemoRenderer> drawing_;  // of the film
  int64_t world_ = 0;                      // that is filmed
};

}  // namespace ballpit
