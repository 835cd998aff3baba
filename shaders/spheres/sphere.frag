#version 450 core
// Intersects the eye's ray with the sphere: exact surface, normal and depth. Only for pixels that it covers completely.
#include "frame.glsl"
#include "shade.glsl"

flat in vec3 center;
flat in float curvature;
flat in float power;
flat in float covered;
flat in vec3 color;
flat in vec2 rim;
in vec3 ray;
in vec2 disc;

layout(depth_greater) out float gl_FragDepth;
layout(location = 0) out vec4 fragment;

void main() {
  if (dot(disc, disc) > covered) discard;

  // |t ray − center|² = r², the nearer root
  float a = dot(ray, ray);
  float b = dot(ray, center);
  float t = (b - sqrt(max(0.0, b * b - a * power))) / a;
  vec3 hit = t * ray;

  vec3 shown = shade(color, (hit - center) * curvature);
  if (rim.x > 0) {
    float inside = 1 - length(disc);
    shown = mix(frame.rim.rgb, shown, clamp((inside - rim.x) / rim.y + 0.5, 0.0, 1.0));
  }
  fragment = vec4(shown, 1);
  float depth = 0.5 - 0.5 * (frame.projection[2].z + frame.projection[3].z / hit.z);
  gl_FragDepth = max(gl_FragCoord.z, depth);
}
