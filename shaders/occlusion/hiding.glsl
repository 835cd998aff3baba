// What hides the sky from a sphere, for its fragments: its strongest occluders and the inner sides of the box.
#include "occlusion.glsl"

layout(location = 3) in vec4 occluder[4];  // [m] xyz: from the sphere's centre to its own; w: its radius, 0 for none
layout(location = 7) in vec4 others;       // the share that all others hide at a normal n: w + dot(xyz, n)

flat out vec4 hiding[4];  // xyz: from the sphere's centre to the occluder's, view space; w: its radius, 0 for none
flat out vec4 fading;     // how much of each occluder counts: none at the reach of the search, so that none appears suddenly
flat out vec4 rest;       // the share that the others and the box hide at a normal n: w + dot(xyz, n)

const float kFades = 1.2, kReach = 1.5;  // of the sum of two radii

// An inner side of the box, `height` away from the centre: half of the sky, less if it is far away.
vec4 side(int k, float height, float half_width) {
  float ratio = max(height, 0.0) / half_width;
  return frame.sides[k].w / (1 + ratio * ratio) * vec4(-frame.sides[k].xyz, 1);
}

void set_hiding(vec3 position, float radius) {
  for (int k = 0; k < 4; ++k) {
    vec4 other = frame.units.w * occluder[k];
    hiding[k] = vec4(mat3(frame.view) * other.xyz, other.w);
    float fades = clamp((kReach - length(other.xyz) / (radius + other.w)) / (kReach - kFades), 0.0, 1.0);
    fading[k] = other.w > 0 ? fades : 0;
  }
  vec3 low = in_units(position), size = frame.box.xyz, high = size - low;
  float half_width = 0.5 * min(size.x, size.z), half_height = 0.5 * size.y;
  rest = vec4(mat3(frame.view) * others.xyz, others.w) + side(0, low.y, half_width) + side(1, low.x, half_height) + side(2, high.x, half_height) +
         side(3, low.z, half_height) + side(4, high.z, half_height);
}
