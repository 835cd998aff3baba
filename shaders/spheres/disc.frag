#version 450 core
// A flat disc with a darker outline inside its radius.
#include "frame.glsl"

flat in vec3 color;
flat in float outline;
in vec2 disc;

layout(location = 0) out vec4 fragment;

void main() {
  float inside = outline - length(disc);  // [pixel] from the edge inwards
  float coverage = clamp(inside + 0.5, 0.0, 1.0);
  if (coverage == 0) discard;
  float line = min(3.0 * frame.line_unit, 0.3 * outline);
  float body = clamp(inside - line + 0.5, 0.0, 1.0);
  fragment = vec4(mix(color * 0.45, color, body), coverage);
}
