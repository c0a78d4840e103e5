// A sampler has the kind of the reads that are left when functions are inlined and conditions folded: engines hand any sampler to
// a function for a feature that is off. The first sampler of each entry is a cube, though a dead read takes it for something else.
// RUN: %clipc -T ps_2_b -E branch %s --target=glsl330 --validate -o - | FileCheck %s
// RUN: %clipc -T ps_2_b -E dummy %s --target=glsl330 --validate -o - | FileCheck %s
// RUN: %clipc -T ps_3_0 -E zero %s --target=vulkan --validate -o - | FileCheck %s
// RUN: %clipc -T ps_3_0 -E unused %s --target=webgl1 --validate -o - | FileCheck %s
// RUN: %clipc -T ps_3_0 -E argument %s --target=glsl450 --validate -o - | FileCheck %s
// RUN: %clipc -T ps_3_0 -E chain %s --target=glsl450 --validate -o - | FileCheck %s
// RUN: %clipc -T ps_3_0 -E chosen %s --target=glsl450 --validate -o - | FileCheck %s
// RUN: %clipc -T ps_3_0 -E selected %s --target=glsl450 --validate -o - | FileCheck %s
// RUN: %draw compare %s -T ps_3_0 -E chain
// RUN: %draw compare %s -T ps_2_b -E dummy
// CHECK-NOT: sampler{{[123]}}D
// CHECK: uniform {{.*}}samplerCube cubes
// CHECK-NOT: sampler{{[123]}}D
sampler cubes : register(s0);
float4 read(float3 u, const bool cube) {
  if (cube) return texCUBE(cubes, u);
  else return tex2D(cubes, u.xy);
}
float4 branch(float3 u : TEXCOORD0) : COLOR { return read(u, true); }

float warped(float x, sampler warp, const bool on) {
  if (on) return tex1D(warp, x).x;
  return x;
}
float4 dummy(float3 u : TEXCOORD0) : COLOR { return texCUBE(cubes, u) * warped(u.x, cubes, false); }

float4 zero(float3 u : TEXCOORD0) : COLOR {
  if (0) return tex3D(cubes, u);
  return texCUBE(cubes, u);
}

float4 unused(float3 u : TEXCOORD0) : COLOR {
  float4 flat = tex2D(cubes, u.xy);
  float4 more = flat * 2;
  return texCUBE(cubes, u);
}

float4 mixed(float4 texel, float3 u, const bool on) {
  if (on) return texel;
  return texCUBE(cubes, u);
}
float4 argument(float3 u : TEXCOORD0) : COLOR { return mixed(tex2D(cubes, u.xy), u, false); }

float4 kind(float3 u, const int kind) {
  if (kind == 0) return tex2D(cubes, u.xy);
  else if (kind == 1) return texCUBE(cubes, u);
  else if (kind == 2) return texCUBE(cubes, -u);
  return tex3D(cubes, u);
}
float4 outer(float3 u, const int last) { return kind(u, 1) + kind(u, last - 1); }
float4 chain(float3 u : TEXCOORD0) : COLOR { return outer(u, 3) * 0.5; }

float4 chosen(float3 u : TEXCOORD0) : COLOR {
  const bool is_flat = false;
  return is_flat ? tex2D(cubes, u.xy) : texCUBE(cubes, u);
}

float4 selected(float3 u : TEXCOORD0) : COLOR {
  const int which = 1;
  switch (which) {
    case 0: return tex2D(cubes, u.xy);
    case 1: return texCUBE(cubes, u);
    default: return 0;
  }
}
