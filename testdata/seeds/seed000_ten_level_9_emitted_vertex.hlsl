// "User clip planes on feature level 9 hardware", 10Level9 feature levels: planes are dotted with the vertex as the shader
// emits it, in clip space before the division, whatever is done to it afterwards for OpenGL.
// RUN: %clipc -T vs_5_0 --depth-range=negative-one-to-one --flip-y %s -o - | FileCheck %s
// RUN: %clipc -T vs_4_0_level_9_1 --target=glsl120 --depth-range=negative-one-to-one --flip-y %s -o - | FileCheck %s --check-prefix=LEVEL9
// RUN: %draw compare %s -T vs_5_0 -E main --lower clip-distance --target glsl450,glsl130,vulkan

cbuffer Scene {
  row_major float4x4 to_clip;
  float4 plane;
};

// CHECK: gl_ClipDistance[0] = dot(result, scene.plane);
// CHECK: gl_Position.{{[yz]}} =
// CHECK-NOT: gl_ClipDistance
// LEVEL9: gl_ClipVertex = gl_Position;
// LEVEL9: gl_Position.{{[yz]}} =
[clipplanes(plane)]
float4 main(float4 position : POSITION) : SV_Position { return mul(position, to_clip); }
