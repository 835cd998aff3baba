#version 450 core
flat in vec4 color;
layout(location = 0) out vec4 fragment;

void main() { fragment = color; }
