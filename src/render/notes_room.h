// SPDX-License-Identifier: MIT
// How much room the notes of the overlays and the legend of the colours need, so that they do not cover the scene. They
// lie in the upper corners:
//
//     ┌──────────────────────────────────┐
//     │ ─ 12 apart  ━ 3 contacts   Speed │   a strip above the scene, if a corner of the domain would reach them there
//     │                          ▒▒▒▒▒▒▒ │
//     ├──────────────────────────────────┤
//     │            the scene             │
//
// The room depends on what is shown, but on no numbers, so the scene keeps its place in a film.
#pragma once

#include "render/frame_view.h"

namespace ballpit {

/// For a view whose camera leaves no room for notes. `above`: the part of the picture's height that a page's title takes.
NotesRoom notes_room(const FrameView& view, float text_scale, float above);

/// Whether a rectangle, from `low` to `high`, overlaps the picture of the domain, or of the part that the scene frames. Both in the picture's coordinates: (0, 0)
/// is its upper left corner, and `size` its lower right.
bool overlaps_domain(const DomainBox& domain, const Camera& camera, Vec2 low, Vec2 high, Vec2 size);

}  // namespace ballpit
