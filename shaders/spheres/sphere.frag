#version 450 core
// Exact surface, normal and depth.
#include "frame.glsl"
#include "shade.glsl"
#include "surface.glsl"

layout(depth_greater) out float gl_FragDepth;
layout(location = 0) out vec4 fragment;

void main() {
  if (!is_covered()) discard;
  vec3 hit = nearer_hit();
  fragment = vec4(with_rim(shade(color, (hit - center) * curvature, vec2(1), edge())), 1);
  gl_FragDepth = depth_of(hit);
}
