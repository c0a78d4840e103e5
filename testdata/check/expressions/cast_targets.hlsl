// A cast of a variable can be assigned to; SemaHLSL/derived-to-base.hlsl of DXC's tests has `(Base)d = (Base)e`, and fxc writes such a cast
// back where it is an argument. The components of the value go into those that the cast takes, one after another.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 %s --target=essl100 --validate -o %t
// RUN: %draw compare %s -T vs_5_0
struct A { float4 p; float2 t; };
struct B { float4 p; float2 t; float4 d; };
float4 main(float4 p : POSITION, float f : F) : SV_Position {
  float k = 2;
  float4 q = p;
  // CHECK: q.xyz = temporary;
  (float3)q = float3(1, 2, 3) * f;
  // CHECK-NEXT: vec2 temporary_2 = q.xy * 2.0;
  // CHECK-NEXT: q.xy = temporary_2;
  (float2)q *= 2;
  B b = { p, f, f, q };
  A a = { p * 2, 3, 4 };
  // CHECK: b.p = temporary{{.*}}.p;
  // CHECK-NEXT: b.t = temporary{{.*}}.t;
  (A)b = a;
  float2 n[2] = { 1, 2, 3, 4 };
  int i = 0;
  // CHECK: int temporary_4 = i++;
  // CHECK-NEXT: float temporary_5 = n[temporary_4].x + in_F0;
  // CHECK-NEXT: n[temporary_4].x = temporary_5;
  (float)n[i++] += f;
  // A half is a float; its name changes nothing.
  float sum = ((half)k = 2.5);
  // CHECK: vec4 temporary_7 = vec4(1.25, -2.5, 3.5, in_F0);
  // CHECK: q.xy = {{.*}}[0];
  // CHECK-NEXT: q.zw = {{.*}}[1];
  (float2x2)(float4)(half4)q = float4(1.25, -2.5, 3.5, f);
  float4x4 m = 0;
  // CHECK: m[0].xy = {{.*}}[0];
  // CHECK-NEXT: m[1].xy = {{.*}}[1];
  (float2x2)(float2x3)m = float4x4(p, p, q, q);
  return q + b.p + b.t.xyxy + b.d + k + sum + n[0].x * 4 + n[1].y + i + m[1];
}
