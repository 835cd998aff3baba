// SPDX-License-Identifier: MIT
// A text that describes the pictures of a film. Each frame holds it, so that --resume continues only the same film.
//
//     size 640x360
//     scene lecture-grid
//     …                      one line for each thing that affects the pictures, its name first
#pragma once

#include <string>

#include "show/demo.h"
#include "show/film.h"
#include "show/parse.h"

namespace ballpit {

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
