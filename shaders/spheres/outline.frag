#version 450 core
// Blends the pixels that a sphere covers in part, by the covered fraction.
#include "frame.glsl"
#include "shade.glsl"

flat in vec4 color;
flat in float outline;
flat in vec3 right;
flat in vec3 up;
flat in vec3 outward;
in vec2 disc;

layout(location = 0) out vec4 fragment;

void main() {
  float from_center = length(disc);
  float coverage = (1 - from_center) * outline + 0.5;
  vec3 normal = outward + (disc.x * right + disc.y * up) / max(from_center, 1e-6);
  vec3 shown = color.w > 0 ? frame.rim.rgb : shade(color.rgb, normal);
  fragment = vec4(shown, coverage >= 1 ? 0 : max(coverage, 0.0));
}
