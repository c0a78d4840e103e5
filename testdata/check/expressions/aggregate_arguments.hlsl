// A constructor takes arrays and structs apart: vkd3d's cast-componentwise-compatible.shader_test, line 420.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
struct S { float2 a; int b; };
S Make(float x) { S s = { x, x + 1, 3 }; return s; }
float4 main(float4 p : POSITION, float4x1 m : M, float f : F) : SV_Position {
  int a[3] = (int[3])m;
  S s = { 1, 2, 3 };
  float2x2 n = float2x2(s, f);
  // CHECK: S temporary = Make(in_F0);
  float4 made = float4(f, Make(f));
  return float4(a, f) + float4(s, 4) + made + n[0].xyxy * n[1].xyxy;
}
