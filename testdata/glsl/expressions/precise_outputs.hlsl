// Results, parameters and members that are precise are precise outputs; -Gis makes all outputs precise.
// RUN: %clipc -T vs_5_0 -E members --validate %s -o - | FileCheck %s --check-prefix=MEMBERS
// RUN: %clipc -T vs_5_0 -E result --validate %s -o - | FileCheck %s --check-prefix=RESULT
// RUN: %clipc -T vs_5_0 -E whole --validate %s -o - | FileCheck %s --check-prefix=WHOLE
// RUN: %clipc -T vs_5_0 -E parameter --validate %s -o - | FileCheck %s --check-prefix=PARAMETER
// RUN: %clipc -T vs_5_0 -E planes -Gis --invariant --validate %s -o - | FileCheck %s --check-prefix=ALL
// RUN: %clipc -T vs_5_0 -E planes -Gis --invariant --separable --validate %s -o - | FileCheck %s --check-prefix=BLOCK
// RUN: %clipc -T vs_5_0 -E planes -Gis --invariant --target=essl310 --lower=discard %s -o %t.vert
// RUN: FileCheck %s --input-file=%t.vert --check-prefix=ES
// RUN: %clipc -T vs_5_0 -E result --target=glsl330 --invariant --validate %s -o - 2>&1 | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_5_0 -E planes --target=vulkan -Gis --invariant %s -o %t.spv
// RUN: spirv-dis %t.spv -o - | FileCheck %s --check-prefix=SPIRV
// RUN: %clipc -T vs_5_0 -E global -spirv %s -o %t.spv && spirv-val %t.spv
// RUN: %clipc -T vs_5_0 -E global --validate %s -o - | FileCheck %s --check-prefix=GLOBAL
// RUN: %draw compare %s -T vs_5_0 -E global --lower none
// RUN: %clipc -T ps_5_0 -E pixel --validate %s -o - | FileCheck %s --check-prefix=PIXEL
// RUN: %clipc -T ps_5_0 -E target -Gis --target=essl310 --validate %s -o - | FileCheck %s --check-prefix=TARGET
// RUN: %draw compare %s -T ps_5_0 -E pixel
cbuffer C {
  float4x4 m;
  float4 plane;
};

struct Members {
  precise float4 position : SV_Position;
  precise float2 uv : TEXCOORD0;
  float4 color : COLOR;
};
// MEMBERS: layout(location = 0) precise out vec2 vs_TEXCOORD0;
// MEMBERS-NEXT: layout(location = 1) out vec4 vs_COLOR0;
// MEMBERS-NEXT: {{^}}precise gl_Position;
Members members(float4 p : POSITION) {
  Members result;
  result.position = mul(p, m);
  result.uv = p.xy * p.zw + 1;
  result.color = p * 2 + 1;
  return result;
}

// A result that is precise makes the members precise, whose semantics are their own.
struct Plain {
  float4 position : SV_Position;
  struct { float4 color : COLOR; } inner;
};
// WHOLE: precise out vec4 vs_COLOR0;
// WHOLE-NEXT: {{^}}precise gl_Position;
precise Plain whole(float4 p : POSITION) {
  Plain result;
  result.position = mul(p, m);
  result.inner.color = p * 2 + 1;
  return result;
}

// RESULT: {{^}}precise gl_Position;
// OLD: warning: `precise` has no effect under target `glsl330`, which has no such word; `--invariant` makes positions of several passes agree [-Wtarget-precise]
// OLD: #version 330
// OLD-NOT: precise
// OLD: {{^}}invariant gl_Position;
precise float4 result(float4 p : POSITION) : SV_Position { return mul(p, m); }

// PARAMETER: precise out vec4 vs_NORMAL0;
// PARAMETER-NOT: precise gl_Position;
void parameter(float4 p : POSITION, out precise float4 normal : NORMAL, out float4 position : SV_Position) {
  normal = p * 2 + 1;
  position = mul(p, m);
}

// ALL: precise out float gl_ClipDistance[1];
// ALL-NEXT: {{^}}precise gl_Position;
// ALL-NEXT: {{^}}invariant gl_Position;
// BLOCK: {{^}}    precise float gl_ClipDistance[1];
// BLOCK-NEXT: };
// BLOCK-NEXT: {{^}}precise gl_Position;
// BLOCK-NEXT: {{^}}invariant gl_Position;
// ES: #extension GL_EXT_gpu_shader5 : require
// ES: precise gl_Position;
// SPIRV-DAG: Invariant
// SPIRV-DAG: OpDecorate [[times:%.*]] NoContraction
// SPIRV: [[times]] = OpMatrixTimesVector
[clipplanes(plane)] float4 planes(float4 p : POSITION) : SV_Position { return mul(p, m); }

// GLOBAL: vec4 sum = vec4(0.0);
// GLOBAL-NEXT: {{^}}precise sum;
static precise float4 sum;
float4 Add(float4 p) { return sum += p; }
float4 global(float4 p : POSITION) : SV_Position { return Add(p) + Add(p.wzyx); }

// PIXEL: layout(location = 0) precise out vec4 SV_Target0;
// PIXEL: layout(depth_greater) out float gl_FragDepth;
// PIXEL-NEXT: {{^}}precise gl_FragDepth;
struct Pixel {
  precise float4 color : SV_Target0;
  precise float depth : SV_DepthGreaterEqual;
};
Pixel pixel(float4 p : POSITION) {
  Pixel result;
  result.color = p * plane + p.yzwx;
  result.depth = saturate(p.x * plane.x + 0.25);
  return result;
}

// TARGET: layout(location = 0) precise out vec4 SV_Target0;
float4 target(float4 p : POSITION) : SV_Target { return p * plane + p.yzwx; }
