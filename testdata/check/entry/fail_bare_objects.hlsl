// RUN: not %clipc -T ps_6_0 %s 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_5_0 -E named %s 2>&1 | FileCheck %s --check-prefix=NAMED
// CHECK: [[#@LINE+1]]:23: error: `color` of type `Texture2D<float4>` cannot be an input or output of the entry point [semantic-on-object, X3530]
float4 main(Texture2D color, float2 uv : UV) : SV_Target { return color.Load(0); }
// NAMED: [[#@LINE+1]]:24: error: `color` of type `Texture2D<float4>` cannot be an input or output of the entry point [semantic-on-object, X3530]
float4 named(Texture2D color : COLOR) : SV_Target { return color.Load(0); }
