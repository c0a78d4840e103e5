#version 450

layout(std140, binding = 0, row_major) uniform Camera {  // b0
    mat4 view;
    mat4 projection;
};

layout(location = 0) in vec3 in_POSITION0;  // POSITION0

layout(location = 0) out vec3 vs_TEXCOORD0;  // TEXCOORD0

vec4 shader_main(vec3 direction, out vec3 ray) {
    ray = direction;
    vec3 turned = mat3(view) * direction;
    return (projection * vec4(turned, 1.0)).xyww;
}

void main() {
    vec3 ray;
    vec4 result = shader_main(in_POSITION0, ray);
    vs_TEXCOORD0 = ray;
    gl_Position = result;
}
