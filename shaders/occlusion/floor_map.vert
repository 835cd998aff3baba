#version 450 core
// The part of the floor that a sphere darkens, in a picture of the floor from above.
#include "frame.glsl"
#include "occlusion.glsl"

layout(location = 0) in vec3 position;  // [m]
layout(location = 1) in float radius;   // [m]

flat out vec4 sphere;   // centre, radius
flat out vec3 towards;  // the light
out vec2 place;         // on the floor

uniform float highest;  // [radius] of spheres whose shadow is drawn

const float kNear = 2.6;  // [radius] where the sky that it hides has faded

void main() {
  float r = in_units(radius);
  vec3 center = in_units(position);
  towards = transpose(mat3(frame.view)) * frame.key_light.xyz;
  bool has_shadow = towards.y > 0.1 && center.y < highest * r, is_near = center.y < 4 * r;
  if (center.y < 0 || !(has_shadow || is_near)) {
    gl_Position = vec4(0, 0, 2, 1);
    return;
  }
  sphere = vec4(center, r);
  sphere.y = max(center.y, r);
  vec2 low = vec2(1e9), high = vec2(-1e9);
  if (has_shadow) {
    float way = sphere.y / towards.y;
    vec2 foot = sphere.xz - way * towards.xz;
    float reach = (r + soft_edge(way, r)) / towards.y;
    low = foot - reach;
    high = foot + reach;
  }
  if (is_near) {
    low = min(low, sphere.xz - kNear * r);
    high = max(high, sphere.xz + kNear * r);
  }
  place = mix(low, high, vec2(gl_VertexID & 1, gl_VertexID >> 1));
  gl_Position = vec4(place / frame.box.xz * 2 - 1, 0, 1);
}
