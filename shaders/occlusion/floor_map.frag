#version 450 core
// What a sphere leaves of the sky (x) and of the light (y) at the floor. Blending multiplies.
#include "frame.glsl"
#include "occlusion.glsl"

flat in vec4 sphere;
flat in vec3 towards;
in vec2 place;

uniform float highest;  // as in floor_map.vert

layout(location = 0) out vec4 left;

void main() {
  vec3 way = sphere.xyz - vec3(place.x, 0, place.y);
  float r = sphere.w;
  float fade = clamp(1 - length(way.xz) / (2.6 * r), 0.0, 1.0) * clamp(4 - sphere.y / r, 0.0, 1.0);
  float share = hidden_share(way, vec3(0, 1, 0), r) * min(1.0, 2 * fade);
  float light = towards.y > 0.1 && sphere.y < highest * r ? light_left(way, towards, r) : 1;
  left = vec4(1 - share, light, 1, 1);
}
