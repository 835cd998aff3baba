#version 450 core
// The shadow of a sphere close to the floor, around the point under it.
#include "frame.glsl"

layout(location = 0) in vec3 position;  // [m]
layout(location = 1) in float radius;   // [m]

flat out vec2 height_radius;  // of the centre above the floor, and of the sphere
out vec2 place;               // on the floor, from the point under the centre

const float kReach = 2.6;  // [radius] where the shadow has faded

void main() {
  vec3 center = in_units(position);
  float r = in_units(radius);
  if (center.y > 4 * r || center.y < 0) {
    gl_Position = vec4(0, 0, 2, 1);
    return;
  }
  height_radius = vec2(max(center.y, r), r);
  place = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2 - 1) * kReach * r;
  vec3 point = vec3(center.x + place.x, 0, center.z + place.y);
  gl_Position = frame.projection * frame.view * vec4(point, 1);
}
