// What all programs know of the picture that is being drawn; render/frame_uniforms.h is its other side.
layout(std140, binding = 0) uniform Frame {
  mat4 view;
  mat4 projection;
  vec4 key_light;       // towards the light, view space; w: its strength
  vec4 halfway;         // between light and viewer, view space
  vec4 sky;             // upwards, view space; w: light from all around
  vec4 units;           // of shaders: xyz: their origin, the domain's lowest corner [m]; w: 1 / their length, its
                        // longest edge [1/m]
  vec4 shadow;          // x: darkness of shadows on the floor
  vec4 background;      // colour
  vec4 mark_color[18];  // in the order of enum class Mark
  vec2 viewport;        // [pixel]
  float pixel;          // length that one pixel shows at distance 1; anywhere, if orthographic
  float line_unit;      // [pixel] 1/1080 of the picture's height
} frame;

// From metres to lengths of about 1: products of lengths would leave the range of floats where these are far from 1 m.
vec3 in_units(vec3 point) { return (point - frame.units.xyz) * frame.units.w; }
float in_units(float distance) { return distance * frame.units.w; }
