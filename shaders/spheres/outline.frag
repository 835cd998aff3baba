#version 450 core
// Blends the pixels that a sphere covers in part, by the covered fraction.
#include "frame.glsl"
#include "shade.glsl"
#include "edge.glsl"

layout(location = 0) out vec4 fragment;

void main() { fragment = blended(shade(color.rgb, normal_at_edge(), vec2(1), 1.0)); }
