#version 450 core
// One point per sphere if all are smaller than a pixel and a half: a quarter of the vertices of quads.
#include "frame.glsl"

layout(location = 0) in vec3 position;  // [m]
layout(location = 1) in float radius;   // [m]
layout(location = 2) in uint mark;

flat out vec4 color;

const float kLight = 0.9;  // of a whole sphere, on average

void main() {
  vec4 center = frame.view * vec4(in_units(position), 1);
  float pixels = 2 * in_units(radius) / (frame.pixel * length(center.xyz));  // diameter
  color = vec4(kLight * frame.mark_color[mark].rgb, 1);
  gl_PointSize = clamp(pixels, 1.0, 4.0);
  gl_Position = frame.projection * center;
}
