// Places on the disc that a sphere of small.vert shows. The rays to it are taken as parallel: they differ
// by its angular size.
flat in vec4 axis;
flat in vec4 color;
flat in vec4 edge;

// From the middle, across the axis; the outline is at length 1.
vec3 place_on_disc() {
  vec3 ray = vec3(gl_FragCoord.xy * frame.rays.xy + frame.rays.zw, -1);
  return axis.w / dot(ray, axis.xyz) * ray - axis.w * axis.xyz;
}
