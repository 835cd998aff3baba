// What hides the sky from a sphere, for its fragments: its strongest occluders and the inner sides of the box.
#include "occlusion.glsl"

layout(location = 3) in vec4 occluder[4];  // [m] xyz: from the sphere's centre to its own; w: its radius, 0 for none

flat out vec4 hiding[4];  // xyz: from the sphere's centre to the occluder's, view space; w: its radius, 0 for none
flat out vec4 fading;     // how much of each occluder counts: none at the reach of the search, so that none appears suddenly
flat out vec4 walls;      // the share that the box hides at a normal n: w + dot(xyz, n)

const float kFades = 1.2, kReach = 1.5;  // of the sum of two radii
const float kFloor = 0.4, kWall = 0.12;  // what these hide; they are bright, so they give back the rest

// Adds the inner side of the box with this normal, `height` away from the centre. Far away, a side of this half-width hides
// little; a side that shows its back to the viewer is left out, as in a room cut open.
void add_side(vec3 normal, float height, float half_width, float share) {
  vec3 seen = mat3(frame.view) * normal;
  float ratio = max(height, 0.0) / half_width;
  float part = 0.5 * share * smoothstep(0.0, 0.2, dot(normal, frame.towards_eye.xyz)) / (1 + ratio * ratio);
  walls += part * vec4(-seen, 1);
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
  walls = vec4(0);
  add_side(vec3(0, 1, 0), low.y, half_width, kFloor);
  add_side(vec3(1, 0, 0), low.x, half_height, kWall);
  add_side(vec3(-1, 0, 0), high.x, half_height, kWall);
  add_side(vec3(0, 0, 1), low.z, half_height, kWall);
  add_side(vec3(0, 0, -1), high.z, half_height, kWall);
}
