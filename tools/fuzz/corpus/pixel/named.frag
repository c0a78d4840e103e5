#version 300 es
precision highp float;
in vec2 vs_TEXCOORD0;
in vec4 in_var_COLOR1;
out vec4 target;
void main() { target = in_var_COLOR1 + vs_TEXCOORD0.xyxy; }
