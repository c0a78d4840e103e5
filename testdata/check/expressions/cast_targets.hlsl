// A cast of a variable can be assigned to; SemaHLSL/derived-to-base.hlsl of DXC's tests has `(Base)d = (Base)e`, and fxc writes such a cast
// back where it is an argument. The components of the value go into those that the cast takes, one after another.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 %s --target=essl100 --validate -o %t
// RUN: %draw compare %s -T vs_5_0
struct A { float4 p; float2 t; };
struct B { float4 p; float2 t; float4 d; };
float4 main(float4 p : POSITION, float f : F) : SV_Position {
  int k = 2;
  // CHECK: float temporary = in_F0 * 3.5;
  // CHECK-NEXT: k = to_int(temporary);
  (float)k = f * 3.5;
  float4 q = p;
  // CHECK: q.xyz = temporary_2;
  (float3)q = float3(1, 2, 3) * f;
  // CHECK-NEXT: vec2 temporary_3 = q.xy * 2.0;
  // CHECK-NEXT: q.xy = temporary_3;
  (float2)q *= 2;
  B b = { p, f, f, q };
  A a = { p * 2, 3, 4 };
  // CHECK: b.p = temporary{{.*}}.p;
  // CHECK-NEXT: b.t = temporary{{.*}}.t;
  (A)b = a;
  int n[2] = { 1, 2 };
  int i = 0;
  // CHECK: int temporary_5 = i++;
  // CHECK-NEXT: float temporary_6 = float(n[temporary_5]) + in_F0;
  // CHECK-NEXT: n[temporary_5] = to_int(temporary_6);
  (float)n[i++] += f;
  float sum = ((float)k = 2.5);
  // Casts inside another change nothing: vkd3d's lhs-cast.shader_test, line 32, and lhs-partial-assignment.shader_test, line 101.
  // CHECK: vec4 temporary_8 = vec4(1.25, -2.5, 3.5, in_F0);
  // CHECK: q.xy = {{.*}}[0];
  // CHECK-NEXT: q.zw = {{.*}}[1];
  (float2x2)(int4)(half4)q = float4(1.25, -2.5, 3.5, f);
  float4x4 m = 0;
  // CHECK: m[0].xy = {{.*}}[0];
  // CHECK-NEXT: m[1].xy = {{.*}}[1];
  (float2x2)(float2x3)m = float4x4(p, p, q, q);
  return q + b.p + b.t.xyxy + b.d + k + sum + n[0] * 4 + n[1] + i + m[1];
}
