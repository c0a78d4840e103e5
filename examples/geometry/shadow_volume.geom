#version 450

layout(triangles_adjacency) in;
layout(triangle_strip, max_vertices = 12) out;

struct Vertex {
    vec4 world;
};

struct Corner {
    vec4 position;
};

layout(std140, binding = 0) uniform Light {  // b0
    layout(row_major) mat4 view_projection;
    vec3 light;
} light;

bool FacesLight(vec3 a, vec3 b, vec3 c) {
    return dot(cross(b - a, c - a), light.light - a) > 0.0;
}

void append_volume(Corner vertex) {
    gl_Position = vertex.position;
    EmitVertex();
}

Corner At(vec3 position, float w) {
    Corner corner = Corner(light.view_projection * vec4(position, w));
    return corner;
}

void DrawOut(vec3 from, vec3 to) {
    append_volume(At(from, 1.0));
    append_volume(At(from - light.light, 0.0));
    append_volume(At(to, 1.0));
    append_volume(At(to - light.light, 0.0));
    EndPrimitive();
}

void shader_main(Vertex v[6]) {
    if (!FacesLight(v[0].world.xyz, v[2].world.xyz, v[4].world.xyz)) {
        return;
    }
    for (uint i = 0u; i < 6u; i += 2u) {
        uint next = (i + 2u) % 6u;
        if (!FacesLight(v[i].world.xyz, v[i + 1u].world.xyz, v[next].world.xyz)) {
            DrawOut(v[i].world.xyz, v[next].world.xyz);
        }
    }
}

void main() {
    Vertex v[6];
    v[0].world = gl_in[0].gl_Position;
    v[1].world = gl_in[1].gl_Position;
    v[2].world = gl_in[2].gl_Position;
    v[3].world = gl_in[3].gl_Position;
    v[4].world = gl_in[4].gl_Position;
    v[5].world = gl_in[5].gl_Position;
    shader_main(v);
}
