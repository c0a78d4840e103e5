#version 450

layout(vertices = 3) out;

struct Corner {
    vec3 position;
    vec3 normal;
};

struct Cuts {
    float edges[3];
    float inside;
    float roundness;
};

layout(std140, binding = 0) uniform Frame {  // b0
    layout(row_major) mat4 view_projection;
    float cuts;
} frame;

layout(location = 0) in vec3 vs_POSITION0[];  // position : POSITION0
layout(location = 1) in vec3 vs_NORMAL0[];  // normal : NORMAL0

layout(location = 0) out vec3 hs_POSITION0[];  // position : POSITION0
layout(location = 1) out vec3 hs_NORMAL0[];  // normal : NORMAL0
layout(location = 2) patch out float hs_patch_ROUNDNESS0;  // roundness : ROUNDNESS0

float saturate(float x) {
    return min(max(0.0, x), 1.0);  // 0 for NaN
}

void main() {
    uint number = uint(gl_InvocationID);
    Corner result = Corner(vs_POSITION0[number], vs_NORMAL0[number]);
    hs_POSITION0[gl_InvocationID] = result.position;
    hs_NORMAL0[gl_InvocationID] = result.normal;
    if (gl_InvocationID == 0) {
        vec3 flat_ = normalize(cross(vs_POSITION0[1] - vs_POSITION0[0], vs_POSITION0[2] - vs_POSITION0[0]));
        float bend = 0.0;
        for (int i = 0; i < 3; ++i) {
            bend = max(bend, 1.0 - abs(dot(flat_, vs_NORMAL0[i])));
        }
        Cuts all_;
        all_.edges[0] = all_.edges[1] = all_.edges[2] = all_.inside = frame.cuts;
        all_.roundness = 0.75 * saturate(4.0 * bend);
        hs_patch_ROUNDNESS0 = all_.roundness;
        gl_TessLevelOuter[0] = all_.edges[0];
        gl_TessLevelOuter[1] = all_.edges[1];
        gl_TessLevelOuter[2] = all_.edges[2];
        gl_TessLevelInner[0] = all_.inside;
    }
}
