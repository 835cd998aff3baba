// Intersects the eye's ray with the sphere of billboard.glsl. Only for pixels that it covers completely.
flat in vec3 center;
flat in float curvature;
flat in float power;
flat in float covered;
flat in vec3 color;
flat in vec2 rim;
in vec3 ray;
in vec2 disc;

bool is_covered() { return dot(disc, disc) <= covered; }

// How near the outline is: from 0 in the middle of the disc to 1.
float edge() {
  float d2 = dot(disc, disc);
  return d2 * d2 * d2;
}

// |t ray − center|² = r², the nearer root
vec3 nearer_hit() {
  float a = dot(ray, ray);
  float b = dot(ray, center);
  float t = (b - sqrt(max(0.0, b * b - a * power))) / a;
  return t * ray;
}

vec3 with_rim(vec3 shown) {
  if (rim.x <= 0) return shown;
  float inside = 1 - length(disc);
  return mix(frame.rim.rgb, shown, clamp((inside - rim.x) / rim.y + 0.5, 0.0, 1.0));
}

// Never in front of the quad.
float depth_of(vec3 hit) {
  return max(gl_FragCoord.z, 0.5 - 0.5 * (frame.projection[2].z + frame.projection[3].z / hit.z));
}
