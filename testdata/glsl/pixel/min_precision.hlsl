// --min-precision=relaxed: half and the types of minimum precision are `mediump` in the GLSL of OpenGL ES and RelaxedPrecision in SPIR-V.
// Members of buffers keep 32 bits, and so does what is computed of wider operands. Without the option everything has 32 bits.
// RUN: %clipc -T ps_5_0 --target=essl300 --min-precision=relaxed --validate %s -o - -w | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=essl310 --min-precision=relaxed --validate %s -o - -w | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=webgl2 --min-precision=relaxed --validate %s -o - -w | FileCheck %s
// RUN: %clipc -T ps_5_0 -DOLD --target=essl100 --min-precision=relaxed --validate %s -o - -w | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T ps_5_0 --target=essl300 --validate %s -o - -w | FileCheck %s --check-prefix=FULL
// RUN: %clipc -T ps_5_0 --target=essl300 --min-precision=full --validate %s -o - -w | FileCheck %s --check-prefix=FULL
// RUN: %clipc -T ps_5_0 --target=glsl450 --min-precision=relaxed --validate %s -o - 2>&1 | FileCheck %s --check-prefixes=FULL,DESKTOP
// RUN: %clipc -T ps_5_0 -spirv --min-precision=relaxed -S %s -o - | FileCheck %s --check-prefix=SPIRV
// RUN: %clipc -T ps_5_0 -spirv -S %s -o - | FileCheck %s --check-prefix=PLAIN
// RUN: %clipc -T ps_5_0 -spirv --min-precision=relaxed %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_5_0 -spirv -fspv-target-env=vulkan1.3 --min-precision=relaxed %s -o %t.spv && spirv-val --target-env vulkan1.3 %t.spv
// RUN: %clipc -T ps_5_0 -G --min-precision=relaxed %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// FULL-NOT: mediump
// DESKTOP: warning: `--min-precision=relaxed` has no effect: it is for SPIR-V and for the GLSL of OpenGL ES
// PLAIN-NOT: RelaxedPrecision

// CHECK: struct Light {
// CHECK-NEXT: {{^    vec3 color;}}
struct Light {
  min16float3 color;
  float range;
};
// CHECK: struct Surface {
// CHECK-NEXT: mediump vec3 albedo;
// CHECK-NEXT: mediump float gloss;
// CHECK-NEXT: {{^    float depth;}}
struct Surface {
  min16float3 albedo;
  half gloss;
  float depth;
};
cbuffer Frame : register(b0) {
  Light light;
  min16float4 tint;
};
// CHECK: uniform mediump sampler2D map;
// CHECK: uniform highp sampler2D depths;
Texture2D<min16float4> map : register(t0);
Texture2D<float> depths : register(t1);
SamplerState linear_wrap : register(s0);
// CHECK: in mediump vec2 vs_UV0;
// CHECK: in vec3 vs_PLACE0;
// CHECK: layout(location = 0) out mediump vec4 SV_Target0;
// CHECK: mediump float bias = 0.25;
// OLD: varying mediump vec2 vs_UV0;
// OLD: mediump vec4 tint()
static min10float bias = 0.25;
// CHECK: mediump float Shine(mediump float a, inout mediump float b) {
min16float Shine(min16float a, inout half b) {
  b *= 2;
  return pow(a, b) + bias;
}
struct Input {
  min16float2 uv : UV;
  float3 place : PLACE;
#ifndef OLD
  // CHECK-NOT: flat in uint
  nointerpolation min16uint number : NUMBER;
#endif
};
// SPIRV-DAG: OpDecorate %vs_UV0 RelaxedPrecision
// SPIRV-DAG: OpMemberDecorate %Surface 0 RelaxedPrecision
// SPIRV-DAG: OpMemberDecorate %Surface 1 RelaxedPrecision
// SPIRV-DAG: OpDecorate %g RelaxedPrecision
// SPIRV-DAG: OpDecorate %a RelaxedPrecision
half4 main(Input input) : SV_Target {
  Surface s;
  s.albedo = map.Sample(linear_wrap, input.uv).rgb * tint.rgb;
  s.gloss = (half)(input.place.x * input.place.y);
  s.depth = input.place.z + depths.Sample(linear_wrap, input.uv);
  // OLD-NOT: mediump float_array3
  // OLD: {{^    float_array3 list}}
  // CHECK: mediump float list[3] =
  min16float list[3] = {s.gloss, 1, 2};
#ifndef OLD
  // CHECK: mediump uint more =
  min16uint more = input.number + (min16uint)3;
  s.gloss += (half)more;
#endif
  // CHECK: mediump vec3 c =
  min16float3 c = s.albedo * light.color + list[2];
  half g = s.gloss;
  // CHECK: {{^    float full =}}
  float full = input.place.y * s.depth;
  c += Shine(c.x, g);
  return half4(c, g * full);
}
