// Soft light that makes spheres look solid: ambient, more from above, one key light, a faint highlight, a darker edge.
// Assumes a distant viewer on the z axis, so no pixel needs a square root. `left`: how much of the sky and of the key light
// other things leave. `edge`: how near the outline is, 0 to 1.
vec3 shade(vec3 base, vec3 normal, vec2 left, float edge) {
  float around = frame.sky.w * left.x * (0.81 + 0.19 * dot(normal, frame.sky.xyz));
  float key = frame.key_light.w * left.y * max(0.0, 0.25 + 0.75 * dot(normal, frame.key_light.xyz));
  float shine = max(0.0, dot(normal, frame.halfway.xyz));
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;  // to the power of 32
  return base * ((around + key) * (1.0 - frame.shadow.y * edge)) + 0.2 * left.y * shine;
}
