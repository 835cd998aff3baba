// What a sphere takes of the light at a point of a surface. `way` leads from the point to the sphere's centre, `normal`
// has length 1. The tests compile this file as C++, too.

const float kPi = 3.14159265f;
const float kPenumbra = 0.25f;  // half the width of a shadow's edge, of the way from the sphere

// The arc cosine of x from 0 to 1, within 0.0001. Source: Abramowitz and Stegun, 4.4.45.
float arc_cosine(float x) {
  return sqrt(1 - x) * (1.5707288f + x * (-0.2121144f + x * (0.0742610f - 0.0187293f * x)));
}

// The share of the sky that it hides, weighted by the cosine of the angle from the normal: cos θ · sin² σ, where the sphere
// appears with the angular radius σ. If the horizon cuts it, only what is above counts. Source: Quilez, "Sphere
// ambient occlusion", iquilezles.org/articles/sphereao; Snyder, "Area light sources for real-time graphics" (1996).
float hidden_share(vec3 way, vec3 normal, float radius) {
  float distance2 = max(dot(way, way), radius * radius);
  float s2 = radius * radius / distance2;
  float c = dot(normal, way) * inversesqrt(distance2);
  float c2 = c * c;
  if (c2 >= s2) return max(0.0f, c) * s2;
  float q = sqrt((1 - s2) / (1 - c2));
  float cut = arc_cosine(min(abs(c) * q * inversesqrt(s2), 1.0f));
  float lune = c > 0 ? kPi - cut : cut;  // half of what the horizon leaves of the sphere's outline, as an angle
  return (s2 * c * lune - sqrt((s2 - c2) * (1 - s2)) + arc_cosine(min(q, 1.0f))) / kPi;
}

// About the same share with fewer operations, up to 0.24 off where spheres touch: a smooth step across the horizon.
float rough_share(vec3 way, vec3 normal, float radius) {
  float s = min(radius * inversesqrt(dot(way, way)), 1.0f);
  float above = clamp(0.5f + 0.5f * dot(normal, way) / radius, 0.0f, 1.0f);
  return s * s * s * above * above;
}

// The half-width of the edge of its shadow at a distance: the light is not a point. Bounded, so that a ball in flight
// still has a shadow.
float soft_edge(float along, float radius) { return min(kPenumbra * max(along, 0.0f), radius) + 0.1f * radius; }

// The part of a light that it leaves, in the direction `towards` of length 1: 0 in its shadow, 1 outside.
float light_left(vec3 way, vec3 towards, float radius) {
  float along = dot(way, towards);
  float beside = sqrt(max(dot(way, way) - along * along, 0.0f)) - radius;
  float soft = soft_edge(along, radius);
  float shadow = 1 - smoothstep(-soft, soft, beside);
  return 1 - shadow * clamp(along / radius, 0.0f, 1.0f);
}
