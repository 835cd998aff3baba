// The data that all shaders share while a picture is drawn; render/renderer.cpp writes it.
layout(std140, binding = 0) uniform Frame {
  mat4 view;
  mat4 projection;
  vec4 key_light;       // towards the light, view space; w: its strength
  vec4 halfway;         // between light and viewer, view space
  vec4 sky;             // upwards, view space; w: light from all around
  vec4 units;           // of shaders: xyz: the origin, at the domain's lowest corner [m]; w: 1 / the domain's longest
                        // edge [1/m]
  vec4 shadow;          // x: darkness of shadows on the floor; y: of the edge of a sphere
  vec4 box;             // xyz: edges of the domain
  vec4 sides[5];        // of the domain, for shaders/occlusion: floor, −x, +x, −z, +z. xyz: inward normal, view space; w:
                        // half of the sky's share that it hides from a point on it
  vec4 background;      // colour
  vec4 floor;           // colour
  vec4 rim;             // colour of the rim that some marks have
  vec4 mark_color[18];  // in the order of enum class Mark; w: width of the rim [line_unit], or 0
  vec2 viewport;        // [pixel]
  float pixel;          // length of one pixel at distance 1; at any distance if orthographic
  float line_unit;      // [pixel] 1/1080 of the picture's height
  vec4 rays;            // from gl_FragCoord to the eye's ray at distance 1: xy: factors, zw: summands
} frame;

// Scales metres to lengths of about 1, so that products of very large or small lengths stay in the range of float.
vec3 in_units(vec3 point) { return (point - frame.units.xyz) * frame.units.w; }
float in_units(float distance) { return distance * frame.units.w; }
