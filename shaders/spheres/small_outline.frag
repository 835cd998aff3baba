#version 450 core
// Blends the pixels that it covers in part, by the covered fraction.
#include "frame.glsl"
#include "shade.glsl"
#include "small.glsl"

layout(location = 0) out vec4 fragment;

void main() {
  vec3 disc = place_on_disc();
  float d = length(disc), coverage = (1 - d) * edge.w + 0.5;
  vec3 shown = color.w > 0 ? frame.rim.rgb : shade(color.rgb, disc / max(d, 1e-6), vec2(1), 1.0);
  fragment = vec4(shown, coverage >= 1 ? 0 : max(coverage, 0.0));
}
