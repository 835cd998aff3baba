// SPDX-License-Identifier: MIT
// The hand of the user: grabs a sphere in the picture to throw it or to push a handful, and drops spheres in.
//
//     grab ── drag ── drag ── release      the arrow from the sphere to the pointer is the velocity; time stands still
//                                          while the caller does not step, and goes on afterwards
//
// The pointer moves in the plane through the sphere that faces the viewer. With gravity, an arrow as long as the domain
// is high is the speed with which a sphere rises that high. Without it, such an arrow is ten times the speed of the
// spheres. Where contacts are found at the ends of steps, a step may move a sphere by 0.9 radii at most.
#pragma once

#include "show/demo.h"

namespace ballpit {

class Hand {
 public:
  /// `demo` must outlive the hand.
  explicit Hand(Demo& demo) : demo_(demo) {}

  /// Takes the sphere at a place in the picture (see body_at()), to throw it or to push. False if there is none.
  bool grab(const FrameView& view, Vec2 place, ActKind kind);
  void drag(const FrameView& view, Vec2 place);
  void release();  ///< acts
  void cancel();   ///< lets the sphere go as it was
  bool is_aiming() const { return demo_.aim.has_value(); }

  /// Puts in a sphere like most others: where the place is in planar scenes; in space under the ceiling, above what the
  /// place shows; without gravity in the plane through the domain's middle that faces the viewer.
  void drop(const FrameView& view, Vec2 place);

 private:
  void act(const Act& act, const std::string& done);
  std::optional<Vec3d> free_place(const FrameView& view, Vec2 place, double radius) const;

  Demo& demo_;
  Act act_;
  float fastest_ = 0;  // [m/s]
  float time_ = 0;     // [s] in which the sphere moves by the arrow's length
};

}  // namespace ballpit
