// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
cbuffer C { float4 set; };
float4 main(float4 p : POSITION, int i : I) : SV_Position {
  const int fixed = i;
  float4x4 m = 0;
  // CHECK: [[#@LINE+1]]:11: error: `set` is set by the application; a shader cannot assign to it; `static` makes a variable of the shader's own [uniform-assigned, X3025]
  (float3)set = 1;
  // CHECK: [[#@LINE+1]]:10: error: `fixed` is constant; it cannot be assigned to [const-assigned, X3025]
  (float)fixed = 1;
  float f = 1;
  // CHECK: [[#@LINE+1]]:11: error: this cannot be assigned to; {{.*}} [not-assignable, X3025]
  (float3)f = 1;
  // CHECK: [[#@LINE+1]]:10: error: this cannot be assigned to; {{.*}} [not-assignable, X3025]
  (half2)m._11_22 = 1;
  // CHECK: [[#@LINE+1]]:20: error: this cannot be assigned to; {{.*}} [not-assignable, X3025]
  (float)(float2x3)m = 1;
  // CHECK: [[#@LINE+1]]:3: error: a cast from `float4` to `int4` cannot be assigned to; {{.*}} [cast-target-kind, X3025]
  (int4)p = 1;
  // CHECK: [[#@LINE+1]]:3: error: a cast from `float4` to `int4` cannot be assigned to; {{.*}} [cast-target-kind, X3025]
  (float2)(int4)p = float4(1, 2, 3, 4);
  // CHECK: [[#@LINE+1]]:3: error: this cannot be assigned to; {{.*}} [not-assignable, X3025]
  ((int4)p).xy = 1;
  // CHECK: [[#@LINE+1]]:3: error: {{.*}} [swizzle-repeats
  m._11_11[i] = 1;
  return p;
}
