#version 450 core
#include "frame.glsl"
#include "billboard.glsl"
#include "hiding.glsl"

void main() {
  set_billboard();
  set_hiding(position, in_units(radius));
}
