#version 450 core
// A line as a quad of constant width in pixels. An end behind the eye moves to where the line comes into view.
#include "frame.glsl"

layout(location = 0) in vec3 a;
layout(location = 1) in vec4 color_a;
layout(location = 2) in vec3 b;
layout(location = 3) in vec4 color_b;

uniform float width;  // [pixel]

out vec4 color;
noperspective out float across;  // [pixel] from the line's middle

// The line's end in clip space, cut at the near plane z = −w.
vec4 visible_end(vec4 end, vec4 other) {
  float inside = end.z + end.w;
  float other_inside = other.z + other.w;
  if (inside >= 0 || other_inside <= 0) return end;
  return mix(end, other, inside / (inside - other_inside));
}

void main() {
  vec4 clip_a = frame.projection * frame.view * vec4(a, 1);
  vec4 clip_b = frame.projection * frame.view * vec4(b, 1);
  vec4 from = visible_end(clip_a, clip_b);
  vec4 to = visible_end(clip_b, clip_a);
  vec2 way = (to.xy / to.w - from.xy / from.w) * frame.viewport;
  vec2 along = way / max(length(way), 1e-6);
  vec2 normal = vec2(-along.y, along.x);

  bool at_end = gl_VertexID >= 2;
  float side = (gl_VertexID & 1) * 2 - 1;
  across = side * (0.5 * max(width, 1.0) + 0.5);
  color = at_end ? color_b : color_a;
  color.a *= min(width, 1.0);
  gl_Position = at_end ? to : from;
  gl_Position.xy += 2 * across * normal / frame.viewport * gl_Position.w;
}
