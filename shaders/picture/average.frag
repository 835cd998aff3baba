#version 450 core
// Each pixel is the mean of a square of samples.
layout(binding = 0) uniform sampler2D samples;
uniform int per_side;

layout(location = 0) out vec4 fragment;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * per_side;
  vec4 sum = vec4(0);
  for (int y = 0; y < per_side; ++y) {
    for (int x = 0; x < per_side; ++x) sum += texelFetch(samples, first + ivec2(x, y), 0);
  }
  fragment = sum / float(per_side * per_side);
}
