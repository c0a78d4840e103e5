// An array of arrays is not one of textures: a parameter without a size does not take it.
// RUN: not %clipc -T ps_6_0 --target=vulkan %s -o %t 2>&1 | FileCheck %s
Texture2D nested[2][2];
float4 f(Texture2D x[], float2 uv) { return x[0].Load(0); }
// CHECK: [[#@LINE+1]]:50: error: no function `f` takes (Texture2D<float4>[2][2], float2)
float4 main(float2 uv : UV) : SV_Target { return f(nested, uv); }
