// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
struct S { float2 a; Texture2D t; };
S s;
float4 main(float4 p : POSITION) : SV_Position {
  float a[2] = { 1, 2 };
  // CHECK: [[#@LINE+1]]:15: error: cannot convert `S` to `float4` [cannot-convert, X3017]
  p += float4(s, 1);
  // CHECK: [[#@LINE+1]]:8: error: `float4` is made of 4 components; 3 given [wrong-component-count, X3014]
  p += float4(a, 1);
  return p;
}
