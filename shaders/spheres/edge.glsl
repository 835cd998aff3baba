// The pixels that a sphere covers in part, in the quad of outline_quad.glsl.
flat in vec4 color;
flat in float outline;
flat in vec4 right;
flat in vec3 up;
flat in vec3 outward;
in vec2 disc;

vec3 normal_at_edge() { return outward + (disc.x * right.xyz + disc.y * up) / max(length(disc), 1e-6); }

// `shown` with the part of the pixel that the sphere covers.
vec4 blended(vec3 shown) {
  float coverage = (1 - length(disc)) * outline + 0.5;
  return vec4(color.w > 0 ? frame.rim.rgb : shown, coverage >= 1 ? 0 : max(coverage, 0.0));
}
