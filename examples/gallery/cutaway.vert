#version 450

layout(std140, binding = 0) uniform Box {  // b0
    layout(row_major) mat4 view_projection;
    vec3 low;
    uint enabled;
    vec3 high;
    float fade_radius;
} box;

layout(location = 0) in vec3 in_POSITION0;  // position : POSITION0

// clip distances written: 0x7f
// cull distances written: 0x1
out float gl_ClipDistance[7];
out float gl_CullDistance[1];

void main() {
    gl_Position = box.view_projection * vec4(in_POSITION0, 1.0);
    vec3 below = bool(box.enabled) ? in_POSITION0 - box.low : vec3(1.0);
    vec3 above = bool(box.enabled) ? box.high - in_POSITION0 : vec3(1.0);
    float culled = box.fade_radius - length(in_POSITION0);
    gl_ClipDistance[0] = below.x;
    gl_ClipDistance[1] = below.y;
    gl_ClipDistance[2] = below.z;
    gl_ClipDistance[3] = 0.0;
    gl_ClipDistance[4] = above.x;
    gl_ClipDistance[5] = above.y;
    gl_ClipDistance[6] = above.z;
    gl_CullDistance[0] = culled;
}
