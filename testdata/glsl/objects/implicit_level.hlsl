// A vertex has no neighbours to take a level of detail from. fxc refuses (X4532); OpenGL reads level 0, and so does this.
// RUN: %clipc -T vs_5_0 --target=glsl450 --validate -DWANT=1 %s -o - 2>%t.err | FileCheck %s --check-prefix=CHECK
// RUN: FileCheck %s --check-prefix=WARN < %t.err
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o %t 2>&1
// RUN: %clipc -T vs_5_0 --target=essl310 --validate %s -o - 2>%t.err | FileCheck %s --check-prefix=ES
// RUN: %clipc -T vs_5_0 --target=essl320 --validate %s -o - 2>%t.err | FileCheck %s --check-prefix=ES32
// AUTOUPDATE
Texture2D map;
SamplerState smooth;
SamplerComparisonState nearer;

float4 main(float2 uv : TEXCOORD) : SV_Position {
  // WARN: [[#@LINE+1]]:18: warning: `Sample` gets the level of detail from neighbouring pixels, which a vertex shader does not have; it reads level 0 here, fxc reports an error; call `SampleLevel` instead [-Wmethod-level-zero]
  float4 r = map.Sample(smooth, uv);
  // WARN: [[#@LINE+1]]:12: warning: `SampleBias` gets the level of detail from neighbouring pixels, which a vertex shader does not have; it reads level 0 plus the bias here
  r += map.SampleBias(smooth, uv, 1.5, int2(1, -1));
  // WARN: [[#@LINE+1]]:12: warning: `SampleCmp` gets the level
  r += map.SampleCmp(nearer, uv, 0.5);
  // An offset for each of the four texels: OpenGL ES 3.1 knows it as an extension only.
  return r + map.GatherGreen(smooth, uv, int2(0, 0), int2(0, 1), int2(1, 0), int2(-8, 7));
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(binding = 0) uniform sampler2D map_smooth;  // map : t0 with smooth : s0
// CHECK-NEXT: layout(binding = 1) uniform sampler2DShadow map_nearer;  // map : t0 with nearer : s1
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 r = textureLod(map_smooth, in_TEXCOORD0, 0.0);
// CHECK-NEXT:     r += textureLodOffset(map_smooth, in_TEXCOORD0, 1.5, ivec2(1, -1));
// CHECK-NEXT:     r += textureLod(map_nearer, vec3(in_TEXCOORD0, 0.5), 0.0);
// CHECK-NEXT:     gl_Position = r + textureGatherOffsets(map_smooth, in_TEXCOORD0, ivec2[4](ivec2(0, 1), ivec2(1, 2), ivec2(2, 0), ivec2(-8, 7)), 1);
// CHECK-NEXT: }

// ES: #version 310 es
// ES-NEXT: #extension GL_EXT_gpu_shader5 : require
// ES-EMPTY:
// ES-NEXT: layout(binding = 0) uniform highp sampler2D map_smooth;  // map : t0 with smooth : s0
// ES-NEXT: layout(binding = 1) uniform highp sampler2DShadow map_nearer;  // map : t0 with nearer : s1
// ES-EMPTY:
// ES-NEXT: layout(location = 0) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0
// ES-EMPTY:
// ES-NEXT: void main() {
// ES-NEXT:     vec4 r = textureLod(map_smooth, in_TEXCOORD0, 0.0);
// ES-NEXT:     r += textureLodOffset(map_smooth, in_TEXCOORD0, 1.5, ivec2(1, -1));
// ES-NEXT:     r += textureLod(map_nearer, vec3(in_TEXCOORD0, 0.5), 0.0);
// ES-NEXT:     gl_Position = r + textureGatherOffsets(map_smooth, in_TEXCOORD0, ivec2[4](ivec2(0, 1), ivec2(1, 2), ivec2(2, 0), ivec2(-8, 7)), 1);
// ES-NEXT: }

// ES32: #version 320 es
// ES32-EMPTY:
// ES32-NEXT: layout(binding = 0) uniform highp sampler2D map_smooth;  // map : t0 with smooth : s0
// ES32-NEXT: layout(binding = 1) uniform highp sampler2DShadow map_nearer;  // map : t0 with nearer : s1
// ES32-EMPTY:
// ES32-NEXT: layout(location = 0) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0
// ES32-EMPTY:
// ES32-NEXT: void main() {
// ES32-NEXT:     vec4 r = textureLod(map_smooth, in_TEXCOORD0, 0.0);
// ES32-NEXT:     r += textureLodOffset(map_smooth, in_TEXCOORD0, 1.5, ivec2(1, -1));
// ES32-NEXT:     r += textureLod(map_nearer, vec3(in_TEXCOORD0, 0.5), 0.0);
// ES32-NEXT:     gl_Position = r + textureGatherOffsets(map_smooth, in_TEXCOORD0, ivec2[4](ivec2(0, 1), ivec2(1, 2), ivec2(2, 0), ivec2(-8, 7)), 1);
// ES32-NEXT: }
