#version 450 core
// The second of two passes. It writes no depth, so the depth test skips spheres that lie wholly behind what is seen.
#include "frame.glsl"
#include "shade.glsl"
#include "surface.glsl"
#include "hidden.glsl"

layout(binding = 0) uniform sampler2D depth;  // of the first pass

layout(location = 0) out vec4 fragment;

const float kSame = 0.02;  // [radius] surfaces so close to each other are both drawn; the later sphere's is seen

void main() {
  vec3 hit = nearer_hit();
  float seen = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).x;
  float z = frame.projection[3].z / (1 - 2 * seen - frame.projection[2].z);
  if (!is_covered() || (z - hit.z) * curvature > kSame) discard;
  vec3 normal = (hit - center) * curvature;
  fragment = vec4(with_rim(shade(color, normal, light_at(hit - center, normal), edge())), 1);
}
