// SPDX-License-Identifier: MIT
// Sort and sweep (slides 2 to 4): the axis under the scene, where each sphere begins and ends on it, the sorted list,
// and one thread's walk along that list.
//
//          ( 0 )  ( 1 )
//          ⋮   ⋮  ⋮   ⋮                dotted: from a sphere's ends to the axis
//     ─────[───]──[───]─────▶ x        begin: a filled bracket; end: a hollow one
//          b0  e0 b1  e1
//     ┌──┬──┬──┬──┐
//     │b0│e0│b1│e1│                    the list: what the walk meets is sky, ends are grey with a stub
//     └──┴──┴──┴──┘
//
// With many spheres there is room for the brackets only. Cost: proportional to the number of spheres.
#pragma once

#include "render/overlays/overlay.h"
#include "world/inspection.h"

namespace ballpit {

float intervals_room(const Inspection& inspection);

class IntervalsOverlay : public Overlay {
 public:
  void draw(const FrameView& view, Painter& painter, Layer layer) override;
};

}  // namespace ballpit
