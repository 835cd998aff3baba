#version 450 core
// The pixels that a sphere of few pixels covers completely, at one depth. So the depth test comes before this shader.
#include "frame.glsl"
#include "shade.glsl"
#include "small.glsl"

layout(location = 0) out vec4 fragment;

void main() {
  vec3 disc = place_on_disc();
  float d2 = dot(disc, disc);
  if (d2 > edge.x) discard;
  vec3 shown = shade(color.rgb, disc - sqrt(1 - d2) * axis.xyz, vec2(1), d2 * d2 * d2);
  fragment = vec4(mix(frame.rim.rgb, shown, clamp(edge.y - edge.z * d2, 0.0, 1.0)), 1);
}
