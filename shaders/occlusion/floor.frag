#version 450 core
// The floor with what the spheres leave of the light.
#include "frame.glsl"

layout(binding = 1) uniform sampler2D map;

in vec2 place;

layout(location = 0) out vec4 fragment;

const float kLight = 0.5;  // of the darkness: the light's shadow is softer than the contact's

void main() {
  vec2 hidden = 1 - texture(map, place).xy;
  fragment = vec4(frame.floor.rgb * (1 - frame.shadow.x * min(1.0, hidden.x + kLight * hidden.y)), 1);
}
