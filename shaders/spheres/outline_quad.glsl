// A quad in the plane of the sphere's outline, half a pixel larger. Inside the outline, the sphere is in front of the quad, so
// the depth test skips the fragment shader there.
layout(location = 0) in vec3 position;  // [m]
layout(location = 1) in float radius;   // [m]
layout(location = 2) in uint mark;

flat out vec4 color;     // w: whether it has a rim
flat out float outline;  // radius [pixel]
flat out vec4 right;     // of the disc, times the component of the normal in its plane; w: radius
flat out vec3 up;
flat out vec3 outward;   // the other component of the normal
out vec2 disc;           // the outline is at length 1

const float kSmallest = 1.0;  // [pixel] as in billboard.glsl

void set_outline() {
  vec3 center = (frame.view * vec4(in_units(position), 1)).xyz;
  float distance = length(center);
  float r = max(in_units(radius), kSmallest * frame.pixel * distance);
  if (distance <= r || center.z >= 0) {
    gl_Position = vec4(0, 0, 2, 1);
    return;
  }
  vec3 axis = center / distance;
  float sine = r / distance;  // of the angle between axis and outline
  float cosine = sqrt(1 - sine * sine);
  vec3 sideways = cosine * normalize(vec3(-axis.z, 0, axis.x));
  right = vec4(sideways, r);
  up = cross(sideways, axis);
  outward = -sine * axis;

  color = frame.mark_color[mark];
  outline = sine / (cosine * frame.pixel);
  disc = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2 - 1) * (1 + 0.5 / outline);
  vec3 point = distance * cosine * cosine * axis + r * (disc.x * sideways + disc.y * up);
  gl_Position = frame.projection * vec4(point, 1);
}
