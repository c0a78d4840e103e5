// RUN: not %clipc -T ps_4_0 %s 2>&1 | FileCheck %s --check-prefixes=CHECK,NEW
// RUN: not %clipc -T ps_3_0 %s 2>&1 | FileCheck %s --implicit-check-not=pairs
sampler one;
sampler pairs[2];
float4 main(float3 uv : TEXCOORD0) : SV_Target {
  // CHECK-DAG: [[#@LINE+1]]:30: error: sampler `one` is used as a `sampler2D` and as a `samplerCUBE`; {{.*}} [sampler-kinds]
  return tex2D(one, uv.xy) + texCUBE(one, uv) +
  // NEW-DAG: [[#@LINE+1]]:41: error: sampler `pairs` is used as a `sampler2D` and as a `sampler3D`; {{.*}} [sampler-kinds]
         tex2D(pairs[0], uv.xy) + tex3D(pairs[1], uv);
}
