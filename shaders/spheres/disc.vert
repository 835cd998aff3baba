#version 450 core
// A body of a planar scene: a square around it, half a pixel larger.
#include "frame.glsl"

layout(location = 0) in vec3 position;  // [m]
layout(location = 1) in float radius;   // [m]
layout(location = 2) in uint mark;

flat out vec4 color;      // w: width of the rim [pixel], or 0
flat out float outline;  // radius [pixel]
out vec2 disc;           // [pixel] from the centre

const float kSmallest = 1.0;  // [pixel]

void main() {
  color = frame.mark_color[mark] * vec4(1, 1, 1, frame.line_unit);
  outline = max(in_units(radius) / frame.pixel, kSmallest);
  disc = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2 - 1) * (outline + 0.5);
  vec3 point = in_units(position) + vec3(disc * frame.pixel, 0);
  gl_Position = frame.projection * frame.view * vec4(point, 1);
}
