#version 450 core
// A flat disc with a darker outline inside its radius, wide and dark for marks that have a rim.
#include "frame.glsl"

flat in vec4 color;
flat in float outline;
in vec2 disc;

layout(location = 0) out vec4 fragment;

void main() {
  float inside = outline - length(disc);  // [pixel] from the edge inwards
  float coverage = clamp(inside + 0.5, 0.0, 1.0);
  if (coverage == 0) discard;
  float line = min(max(3.0 * frame.line_unit, color.w), 0.2 * outline);
  float body = clamp(inside - line + 0.5, 0.0, 1.0);
  fragment = vec4(mix(color.w > 0 ? frame.rim.rgb : color.rgb * 0.45, color.rgb, body), coverage);
}
