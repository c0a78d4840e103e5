#version 450

struct Vertex {
    vec3 position;
    vec3 normal;
    uvec4 bones;
    vec4 weights;
};

layout(std140, binding = 0) uniform Skeleton {  // b0
    layout(row_major) mat4x3 bones[64];
} skeleton;

layout(std140, binding = 1) uniform Camera {  // b1
    layout(row_major) mat4 view_projection;
} camera;

layout(location = 0) in vec3 in_POSITION0;  // position : POSITION0
layout(location = 1) in vec3 in_NORMAL0;  // normal : NORMAL0
layout(location = 2) in uvec4 in_BLENDINDICES0;  // bones : BLENDINDICES0
layout(location = 3) in vec4 in_BLENDWEIGHT0;  // weights : BLENDWEIGHT0

layout(location = 0) out vec3 vs_NORMAL0;  // normal : NORMAL0

void Skin(Vertex v, out vec3 position, out vec3 normal) {
    position = vec3(0.0);
    normal = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        mat4x3 bone = skeleton.bones[v.bones[i]];
        position += v.weights[i] * (bone * vec4(v.position, 1.0));
        normal += v.weights[i] * (mat3(bone) * v.normal);
    }
}

void main() {
    Vertex v = Vertex(in_POSITION0, in_NORMAL0, in_BLENDINDICES0, in_BLENDWEIGHT0);
    vec3 skinned;
    Skin(v, skinned, vs_NORMAL0);
    gl_Position = camera.view_projection * vec4(skinned, 1.0);
    vs_NORMAL0 = normalize(vs_NORMAL0);
}
