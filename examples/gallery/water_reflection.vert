#version 450

struct Vertex {
    vec3 position;
    vec3 normal;
    vec2 uv;
};

struct Varyings {
    vec4 position;
    vec3 normal;
    vec3 to_eye;
    vec2 uv;
};

layout(std140, binding = 0, row_major) uniform Camera {  // b0
    mat4 view_projection;
    vec3 eye;
    float time;
};

layout(std140, binding = 1, row_major) uniform Object {  // b1
    mat4 world;
    vec4 tint;
};

layout(std140, binding = 2) uniform Clip {  // b2
    vec4 water_plane;
};

layout(location = 0) in vec3 in_POSITION0;  // POSITION0
layout(location = 1) in vec3 in_NORMAL0;  // NORMAL0
layout(location = 2) in vec2 in_TEXCOORD0;  // TEXCOORD0

layout(location = 0) out vec3 vs_NORMAL0;  // NORMAL0
layout(location = 1) out vec3 vs_TEXCOORD1;  // TEXCOORD1
layout(location = 2) out vec2 vs_TEXCOORD0;  // TEXCOORD0
// clip distances written: 0x1
out float gl_ClipDistance[1];

Varyings shader_main(Vertex v) {
    vec4 world_position = world * vec4(v.position, 1.0);
    world_position.y = -world_position.y;
    Varyings o;
    o.position = view_projection * world_position;
    o.normal = normalize(mat3(world) * v.normal) * vec3(1.0, -1.0, 1.0);
    o.to_eye = eye - world_position.xyz;
    o.uv = v.uv + vec2(0.02 * sin(time), 0.0);
    return o;
}

void main() {
    Vertex v;
    v.position = in_POSITION0;
    v.normal = in_NORMAL0;
    v.uv = in_TEXCOORD0;
    Varyings result = shader_main(v);
    gl_Position = result.position;
    vs_NORMAL0 = result.normal;
    vs_TEXCOORD1 = result.to_eye;
    vs_TEXCOORD0 = result.uv;
    gl_ClipDistance[0] = dot(result.position, water_plane);
}
