#version 450
struct Varyings { vec2 uv; mat3 tangents; uint material; vec4 colors[2]; };
layout(location = 1) flat in Varyings v;
in Bare { layout(location = 9) vec3 none; };
layout(location = 0) out vec4 target;
void main() { Varyings w = v; target = w.uv.xyxy + vec4(v.tangents[1], float(v.material)) + v.colors[1]; }
