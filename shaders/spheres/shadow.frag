#version 450 core
// Ambient occlusion of a plane by a sphere, cos θ · r²/d² (I. Quilez, "sphere ambient occlusion"), faded to zero.
#include "frame.glsl"

flat in vec2 height_radius;
in vec2 place;

layout(location = 0) out vec4 fragment;

void main() {
  float h = height_radius.x;
  float r = height_radius.y;
  float d2 = h * h + dot(place, place);
  float occlusion = h * r * r / (d2 * sqrt(d2));
  float fade = clamp(1 - length(place) / (2.6 * r), 0.0, 1.0) * clamp(4 - h / r, 0.0, 1.0);
  fragment = vec4(0, 0, 0, frame.shadow.x * occlusion * min(1.0, 2 * fade));
}
