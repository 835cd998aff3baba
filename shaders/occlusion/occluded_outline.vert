#version 450 core
#include "frame.glsl"
#include "outline_quad.glsl"
#include "hiding.glsl"

void main() {
  set_outline();
  set_hiding(position, in_units(radius));
}
