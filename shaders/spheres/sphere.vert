#version 450 core
#include "frame.glsl"
#include "billboard.glsl"

void main() { set_billboard(); }
