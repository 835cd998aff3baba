#version 450 core
// A sphere of few pixels as one point: a square around its outline, which is an ellipse in the picture.
#include "frame.glsl"

layout(location = 0) in vec3 position;  // [m]
layout(location = 1) in float radius;   // [m]
layout(location = 2) in uint mark;

uniform float beyond;  // [pixel] the outline is drawn so far, negative: within it
uniform float nearer;  // [m] the depth is that of the sphere's centre, moved so far towards the viewer
uniform float margin;  // [pixel] of the viewport around the view: a point is cut off if its centre is outside

flat out vec4 axis;   // towards the centre, view space; w: cotangent of the angle from there to the outline
flat out vec4 color;  // w: whether it has a rim
flat out vec4 edge;   // for d² on the disc: x: of pixels that are covered completely; y − z d²: of a pixel, the part
                      // inside the rim; w: radius of the outline [pixel]
invariant gl_Position;

const float kSmallest = 1.0;  // [pixel] as in billboard.glsl

void main() {
  vec3 center = (frame.view * vec4(in_units(position), 1)).xyz;
  float distance = length(center), depth = -center.z;
  float r = max(in_units(radius), kSmallest * frame.pixel * distance);
  gl_PointSize = 1;
  if (depth <= r) {  // the eye is inside, or the sphere behind it
    gl_Position = vec4(0, 0, 2, 1);
    return;
  }
  float tangent = r / sqrt(distance * distance - r * r), outline = tangent / frame.pixel;
  axis = vec4(center / distance, 1 / tangent);
  color = frame.mark_color[mark];
  float inner = max(0.0, 1 - 0.5 / outline);
  float rim = 1 - min(color.w * frame.line_unit / outline, 0.16), slope = outline / (2 * rim);
  edge = vec4(inner * inner, color.w > 0 ? vec2(slope * rim * rim + 0.5, slope) : vec2(1, 0), outline);

  // The planes through the eye that touch the sphere bound the ellipse.
  float power = depth * depth - r * r, aside = max(abs(center.x), abs(center.y));
  gl_PointSize = max(1.0, 2 * r * sqrt(aside * aside + power) / (power * frame.pixel) * (1 + beyond / outline));
  gl_Position = frame.projection * vec4(center.xy * (depth * depth / power), center.z, 1);
  float moved = min(center.z + in_units(nearer), -0.5 * depth);
  gl_Position.z = (frame.projection[2].z * moved + frame.projection[3].z) / -moved * gl_Position.w;
  gl_Position.xy *= frame.viewport / (frame.viewport + 2 * margin);
}
