#version 450

layout(triangles, equal_spacing, ccw) in;

struct Corner {
    vec3 position;
    vec3 normal;
};

layout(std140, binding = 0) uniform Frame {  // b0
    layout(row_major) mat4 view_projection;
    float cuts;
} frame;

layout(location = 0) in vec3 hs_POSITION0[];  // position : POSITION0
layout(location = 1) in vec3 hs_NORMAL0[];  // normal : NORMAL0
layout(location = 2) patch in float hs_patch_ROUNDNESS0;  // roundness : ROUNDNESS0

layout(location = 0) out vec3 ds_NORMAL0;  // normal : NORMAL0

vec3 OnPlane(vec3 position, Corner corner) {
    return position - dot(position - corner.position, corner.normal) * corner.normal;
}

void main() {
    Corner patch_[3];
    patch_[0].position = hs_POSITION0[0];
    patch_[0].normal = hs_NORMAL0[0];
    patch_[1].position = hs_POSITION0[1];
    patch_[1].normal = hs_NORMAL0[1];
    patch_[2].position = hs_POSITION0[2];
    patch_[2].normal = hs_NORMAL0[2];
    vec3 at = gl_TessCoord;
    vec3 flat_ = at.x * patch_[0].position + at.y * patch_[1].position + at.z * patch_[2].position;
    vec3 bulged = at.x * OnPlane(flat_, patch_[0]) + at.y * OnPlane(flat_, patch_[1]) + at.z * OnPlane(flat_, patch_[2]);
    gl_Position = frame.view_projection * vec4(mix(flat_, bulged, hs_patch_ROUNDNESS0), 1.0);
    ds_NORMAL0 = normalize(at.x * patch_[0].normal + at.y * patch_[1].normal + at.z * patch_[2].normal);
}
