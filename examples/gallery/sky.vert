#version 450

layout(std140, binding = 0) uniform Camera {  // b0
    layout(row_major) mat4 view;
    layout(row_major) mat4 projection;
} camera;

layout(location = 0) in vec3 in_POSITION0;  // direction : POSITION0

layout(location = 0) out vec3 vs_TEXCOORD0;  // ray : TEXCOORD0

void main() {
    vs_TEXCOORD0 = in_POSITION0;
    vec3 turned = mat3(camera.view) * in_POSITION0;
    gl_Position = (camera.projection * vec4(turned, 1.0)).xyww;
}
