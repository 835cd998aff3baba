// SPDX-License-Identifier: MIT
// What a demonstration leaves on the disk while it is operated: pictures, states and films, under the first free names in the
// current folder. What was saved, or why not, is said to the audience. Needs the OpenGL context that pictures are drawn in.
#pragma once

#include <memory>

#include "show/demo.h"
#include "show/demo_renderer.h"
#include "show/film.h"
#include "show/parse.h"

namespace ballpit {

class Saver {
 public:
  /// `demo` must outlive the saver.
  explicit Saver(Demo& demo) : demo_(demo) {}

  /// The scene alone, each pixel averaged from 2 × 2.
  void save_picture(PictureSize size);

  /// As `ballpit simulate --out` writes it.
  void save_state();

  /// Frames from now on, sixty a simulated second, as `ballpit render` draws them: one with each go_on(), of the world of now. Pauses.
  void start_film(PictureSize size, int frames);
  void go_on();
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
