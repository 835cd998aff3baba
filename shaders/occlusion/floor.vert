#version 450 core
#include "frame.glsl"

out vec2 place;  // 0 to 1 along both edges

void main() {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = frame.projection * frame.view * vec4(place.x * frame.box.x, 0, place.y * frame.box.z, 1);
}
