// SPDX-License-Identifier: MIT
// What a page of a lecture adds to a picture: title, caption and slide number, and the lines of the kernel that it
// steps through. They have parts of the picture to themselves; the scene fills the rest. A window and films also have
// a title and a caption. In a picture that compares methods, each view has a page of its own.
//
//     ┌───────────────────────────────┐
//     │ title                         │
//     ├─────────────────┬─────────────┤
//     │                 │ kernel      │
//     │ scene           │ ▸ its line  │
//     │                 │ what it did │
//     ├─────────────────┴─────────────┤
//     │ arrays (overlays)             │
//     │ caption                slides │
//     └───────────────────────────────┘
#pragma once

#include <string>
#include <vector>

#include "render/camera.h"

namespace ballpit {

struct Painter;
struct Inspection;

/// The sign of a broad phase before its title; charts draw its points alike.
enum class MethodSign { none, ring, triangle, square, diamond };

struct PageView {
  std::string title, caption;
  MethodSign sign = MethodSign::none;  ///< before the title
  std::vector<std::string> figures;    ///< in place of a caption: lines that shrink where they are too long
  std::string slides;                  ///< "Slide 7", or empty
  std::vector<std::string> code;       ///< lines of the kernel's function; none without a kernel
  int line = -1;                       ///< the index in `code` of the line that was run last
  std::string step;                    ///< what it did: "thread 2: atomicExch(&head[4], 2) returns 6"
  std::string touched_array;           ///< "head": the array that the step read or wrote, or empty
  int64_t touched_index = -1;
  std::string old_text;       ///< the element's value before the step, if that changed it
  bool walks = true;          ///< whether the intervals show a thread that walks
  bool has_walked = false;    ///< whether they show all threads: the sweep is over
  bool has_no_scene = false;  ///< only text is shown: a page that failed to load
  bool is_still = true;       ///< whether its spheres stand still
  bool has_views = false;     ///< other views are drawn below its title, with a line between them
  float below = 0;            ///< [of the picture's height] what caption and overlays take at the lower edge
};

/// The parts of a view of this aspect that the page needs, beside what overlays take below. `share`: the view's height
/// [of the picture's].
Room room_of(const PageView& page, float text_scale, float aspect, float share = 1);

/// Marks element `index` of an array, whose box is drawn from `low` to `high` [pixel], if the step has touched it: an
/// outline, and the old value struck through.
void mark_touched(const PageView& page, std::string_view array, int64_t index, Vec2 low, Vec2 high, Painter& painter);

/// Draws the texts, and takes their parts of the picture.
void draw_page(const PageView& page, Painter& painter);

}  // namespace ballpit
