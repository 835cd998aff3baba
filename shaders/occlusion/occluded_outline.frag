#version 450 core
#include "frame.glsl"
#include "shade.glsl"
#include "edge.glsl"
#include "hidden.glsl"

layout(location = 0) out vec4 fragment;

void main() {
  vec3 normal = normal_at_edge();
  fragment = blended(shade(color.rgb, normal, light_at_edge(right.w * normal, normal), 1.0));
}
