#version 450 core
// A line as a quad of constant width in pixels. An end behind the eye moves to the point where the line comes into view.
#include "frame.glsl"

// In the layout of the host. Not an instance per line, which takes a software renderer much longer.
struct Line {
  float a[3];
  uint color_a;
  float b[3];
  uint color_b;
};
layout(std430, binding = 1) readonly buffer Lines { Line lines[]; };

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

const int kCorners[6] = int[](0, 1, 2, 2, 1, 3);  // of two triangles

vec4 clip(float p[3]) { return frame.projection * (frame.view * vec4(in_units(vec3(p[0], p[1], p[2])), 1)); }

void main() {
  Line line = lines[gl_VertexID / 6];
  int corner = kCorners[gl_VertexID % 6];
  vec4 clip_a = clip(line.a);
  vec4 clip_b = clip(line.b);
  vec4 from = visible_end(clip_a, clip_b);
  vec4 to = visible_end(clip_b, clip_a);
  vec2 way = (to.xy / to.w - from.xy / from.w) * frame.viewport;
  vec2 along = way / max(length(way), 1e-6);
  vec2 normal = vec2(-along.y, along.x);

  bool at_end = corner >= 2;
  float side = (corner & 1) * 2 - 1;
  across = side * (0.5 * max(width, 1.0) + 0.5);
  color = unpackUnorm4x8(at_end ? line.color_b : line.color_a);
  color.a *= min(width, 1.0);
  gl_Position = at_end ? to : from;
  gl_Position.xy += 2 * across * normal / frame.viewport * gl_Position.w;
}
