// What all programs know of the picture that is being drawn; render/frame_uniforms.h is its other side.
layout(std140, binding = 0) uniform Frame {
  mat4 view;
  mat4 projection;
  vec4 key_light;       // towards the light, view space; w: its strength
  vec4 halfway;         // between light and viewer, view space
  vec4 sky;             // upwards, view space; w: light from all around
  vec4 floor_level;     // x: height of the floor [m]; y: darkness of shadows on it
  vec4 background;      // colour
  vec4 mark_color[18];  // in the order of enum class Mark
  vec2 viewport;        // [pixel]
  float pixel;          // length [m] that one pixel shows at distance 1 m; anywhere, if orthographic
  float line_unit;      // [pixel] 1/1080 of the picture's height
} frame;
