#version 450
layout(location = 0) in Varyings { vec2 uv; mat3 tangents; flat uint material; vec4 colors[2]; } v;
layout(location = 0) out vec4 target;
void main() { target = v.uv.xyxy + vec4(v.tangents[1], float(v.material)) + v.colors[1]; }
