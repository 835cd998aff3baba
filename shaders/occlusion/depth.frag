#version 450 core
// The first of two passes: where the surfaces are. So the second one computes light only for what is seen.
#include "frame.glsl"
#include "surface.glsl"

layout(depth_greater) out float gl_FragDepth;

void main() {
  if (!is_covered()) discard;
  gl_FragDepth = depth_of(nearer_hit());
}
