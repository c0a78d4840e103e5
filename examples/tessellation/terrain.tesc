#version 450

layout(vertices = 4) out;

struct Corner {
    vec3 position;
};

struct Cuts {
    float edges[4];
    float inside[2];
};

layout(std140, binding = 0) uniform Frame {  // b0
    layout(row_major) mat4 view_projection;
    vec4 water_plane;
    vec3 eye;
    float height;
    float cuts_at_one_unit;
} frame;

layout(location = 0) in vec3 vs_POSITION0[];  // position : POSITION0

layout(location = 0) out vec3 hs_POSITION0[];  // position : POSITION0

float CutsOf(vec3 a, vec3 b) {
    return clamp(frame.cuts_at_one_unit * distance(a, b) / distance(frame.eye, (a + b) / 2.0), 1.0, 64.0);
}

void main() {
    uint number = uint(gl_InvocationID);
    Corner result = Corner(vs_POSITION0[number]);
    hs_POSITION0[gl_InvocationID] = result.position;
    if (gl_InvocationID == 0) {
        Cuts cuts;
        cuts.edges[0] = CutsOf(vs_POSITION0[0], vs_POSITION0[2]);
        cuts.edges[1] = CutsOf(vs_POSITION0[0], vs_POSITION0[1]);
        cuts.edges[2] = CutsOf(vs_POSITION0[1], vs_POSITION0[3]);
        cuts.edges[3] = CutsOf(vs_POSITION0[2], vs_POSITION0[3]);
        cuts.inside[0] = (cuts.edges[1] + cuts.edges[3]) / 2.0;
        cuts.inside[1] = (cuts.edges[0] + cuts.edges[2]) / 2.0;
        gl_TessLevelOuter[0] = min(cuts.edges[0], 64.0);
        gl_TessLevelOuter[1] = min(cuts.edges[1], 64.0);
        gl_TessLevelOuter[2] = min(cuts.edges[2], 64.0);
        gl_TessLevelOuter[3] = min(cuts.edges[3], 64.0);
        gl_TessLevelInner[0] = min(cuts.inside[0], 64.0);
        gl_TessLevelInner[1] = min(cuts.inside[1], 64.0);
    }
}
