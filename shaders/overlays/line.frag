#version 450 core
uniform float width;  // [pixel]

in vec4 color;
noperspective in float across;

layout(location = 0) out vec4 fragment;

void main() {
  float coverage = clamp(0.5 * max(width, 1.0) + 0.5 - abs(across), 0.0, 1.0);
  fragment = vec4(color.rgb, color.a * coverage);
}
