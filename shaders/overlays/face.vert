#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 u;
layout(location = 2) in vec3 v;
layout(location = 3) in vec4 face_color;

flat out vec4 color;

void main() {
  vec3 point = in_units(corner + (gl_VertexID & 1) * u + (gl_VertexID >> 1) * v);
  color = face_color;
  gl_Position = frame.projection * frame.view * vec4(point, 1);
}
