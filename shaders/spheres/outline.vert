#version 450 core
#include "frame.glsl"
#include "outline_quad.glsl"

void main() { set_outline(); }
