// The index in m[f()]._m00_m11 is computed once, where components of that matrix are read and written.
// RUN: %clipc -T vs_5_0 %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
float4 u;
static int calls;
int next() {
  calls++;
  return calls & 1;
}
void change(inout float2 x) { x = x * 2 + 1; }

// CHECK: int temporary = next();
// CHECK-NEXT: vec2 temporary_2 = vec2(m[temporary][0][0], m[temporary][1][1]) * 10.0;
// CHECK-NEXT: m[temporary][0][0] = temporary_2.x;
// CHECK-NEXT: m[temporary][1][1] = temporary_2.y;
float4 main(float4 p : POSITION, out float4 d : D) : SV_Position {
  float4x4 m[2] = {{p, p, p, p}, {u, u, u, u}};
  m[next()]._m00_m11 *= 10;
  m[next()]._11_22.yx = p.xy;
  m[next()]._m10_m01 = m[next()]._m03_m30;
  float2 fraction = modf(p.xy, m[next()]._m01_m12);
  change(m[next()]._m22_m33);
  m[next()]._m02_m20++;
  d = mul(m[1], u) + calls + fraction.xyxy;
  return mul(m[0], p);
}
