// A quad in the sphere's near tangent plane, facing the viewer, that just covers the sphere's outline.
// The whole sphere is behind it, so the fragment shader only moves depth away from the viewer.
layout(location = 0) in vec3 position;  // [m]
layout(location = 1) in float radius;   // [m]
layout(location = 2) in uint mark;

flat out vec3 center;     // view space
flat out float curvature; // 1/radius
flat out float power;     // of the eye with respect to the sphere: distance² − radius²
flat out float covered;   // squared length of disc up to which pixels are covered completely
flat out vec3 color;
flat out vec2 rim;        // width, and 1 [pixel], in lengths of disc; no rim: 0
out vec3 ray;             // from the eye to the tangent plane
out vec2 disc;            // on that plane; the outline is at length 1

const float kSmallest = 1.0;  // [pixel] smallest radius, so that distant spheres remain visible

void set_billboard() {
  center = (frame.view * vec4(in_units(position), 1)).xyz;
  float distance = length(center);
  float r = max(in_units(radius), kSmallest * frame.pixel * distance);
  if (distance <= r || center.z >= 0) {  // the eye is inside, or the sphere behind it
    gl_Position = vec4(0, 0, 2, 1);
    return;
  }
  float plane = distance - r;
  float size = plane * r / sqrt(distance * distance - r * r);
  vec3 axis = center / distance;
  vec3 right = normalize(vec3(-axis.z, 0, axis.x));
  vec3 up = cross(right, axis);

  float outline = size / (plane * frame.pixel);  // radius [pixel]
  float inner = max(0.0, 1 - 0.5 / outline);
  curvature = 1 / r;
  power = distance * distance - r * r;
  covered = inner * inner;
  color = frame.mark_color[mark].rgb;
  rim = vec2(min(frame.mark_color[mark].w * frame.line_unit / outline, 0.16), 1 / outline);
  disc = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2 - 1;
  ray = plane * axis + size * (disc.x * right + disc.y * up);
  gl_Position = frame.projection * vec4(ray, 1);
}
