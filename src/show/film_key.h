// SPDX-License-Identifier: MIT
// What the frames of a film show, as text that each of them carries: so that --resume goes on with a film of its own only.
//
//     size 640x360
//     scene lecture-grid
//     …                      one line for each thing that changes pictures, its name first
#pragma once

#include <string>

#include "show/demo.h"
#include "show/film.h"
#include "show/parse.h"

namespace ballpit {

/// What of a film neither its plan nor the demonstration knows.
struct FilmLook {
  PictureSize size;
  int supersample = 1;
  bool has_panel = false;
  std::string clicks = {};  ///< on the panel
};

/// The key of a film that begins with the present state. Options that change no picture (threads, backend, limits that stop a
/// run) are not in it.
std::string film_key(Demo& demo, const FilmPlan& plan, const FilmLook& look);

/// Throws UserError where one of the first `count` frames in a folder has another key; of frames without one, another size.
void check_frames(const std::string& folder, int count, const std::string& key);

}  // namespace ballpit
