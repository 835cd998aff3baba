// What is left of the light at a point of a sphere.
#include "occlusion.glsl"

flat in vec4 hiding[4];  // as in hiding.glsl
flat in vec4 fading;
flat in vec4 rest;

const float kGivenBack = 0.2;  // by the surfaces that hide it, which are bright

// x: of the sky; y: of the key light. Occluders overlap, so the product of what each leaves is an approximation.
// `from_center` leads from the sphere's centre to the point.
vec2 light_at(vec3 from_center, vec3 normal) {
  vec2 left = vec2(1 - clamp(rest.w + dot(rest.xyz, normal), 0.0, 1.0), 1);
  for (int k = 0; k < 4; ++k) {
    vec3 way = hiding[k].xyz - from_center;
    float radius = max(hiding[k].w, 1e-6);
    float share = hidden_share(way, normal, radius);
    float light = light_left(way, frame.key_light.xyz, radius);
    left *= 1 - fading[k] * (1 - vec2(1 - share, light));
  }
  return mix(left, vec2(1), kGivenBack);
}

// The same for the pixels of an outline, which are seen in part: roughly, with the sky's share for the light as well.
vec2 light_at_edge(vec3 from_center, vec3 normal) {
  float left = 1 - clamp(rest.w + dot(rest.xyz, normal), 0.0, 1.0);
  for (int k = 0; k < 4; ++k) {
    left *= 1 - fading[k] * rough_share(hiding[k].xyz - from_center, normal, max(hiding[k].w, 1e-6));
  }
  return vec2(mix(left, 1, kGivenBack));
}
