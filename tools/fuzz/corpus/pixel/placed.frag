#version 450
layout(std140, binding = 0) uniform Frame { layout(row_major) mat4 view; vec4 tint; } frame;
layout(location = 0) in vec2 uv;
layout(location = 1) in mat3 tangents;
layout(location = 4) flat in uint material;
layout(location = 5) in vec4 colors[2];
layout(location = 0) out vec4 target;
void main() { target = colors[1] * frame.tint + vec4(tangents * vec3(uv, 1.0), float(material)); }
