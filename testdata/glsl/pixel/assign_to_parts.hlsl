// A vector of variables may be assigned to. fxc takes it: its listing of the DirectX SDK's ParallaxOcclusionMapping, in HLSLCrossCompiler's
// tests, has one derivative for both parts.
// RUN: %clipc -T ps_4_0 --target=glsl450 --verify --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_4_0 --target glsl450,essl300,vulkan
// AUTOUPDATE
float4 main(float4 uv : TEXCOORD, float2 size : SIZE) : SV_Target {
  float2 a, b;
  float3 c[2] = {uv.xyz, uv.zyx};
  float4(a, b) = ddx(float4(uv.xy * size, uv.xy));
  float3(c[1].x, c[0].zy) = uv.wzy * 8;
  return float4(a + b, c[1].x, c[0].y - c[0].z);
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 vs_TEXCOORD0;  // uv : TEXCOORD0
// CHECK-NEXT: layout(location = 1) in vec2 vs_SIZE0;  // size : SIZE0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) out vec4 SV_Target0;  // main : SV_Target0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec2 a;
// CHECK-NEXT:     vec2 b;
// CHECK-NEXT:     vec3 c[2] = vec3[2](vs_TEXCOORD0.xyz, vs_TEXCOORD0.zyx);
// CHECK-NEXT:     vec4 temporary = dFdx(vec4(vs_TEXCOORD0.xy * vs_SIZE0, vs_TEXCOORD0.xy));
// CHECK-NEXT:     a = temporary.xy;
// CHECK-NEXT:     b = temporary.zw;
// CHECK-NEXT:     vec3 temporary_2 = vs_TEXCOORD0.wzy * 8.0;
// CHECK-NEXT:     c[1].x = temporary_2.x;
// CHECK-NEXT:     c[0].zy = temporary_2.yz;
// CHECK-NEXT:     SV_Target0 = vec4(a + b, c[1].x, c[0].y - c[0].z);
// CHECK-NEXT: }
