// Swizzles of matrix swizzles and their elements are assigned to as the components that they name;
// functions write into them as well.
// RUN: %clipc -T vs_5_0 %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// CHECK-NOT: vec2(
float4 main(float4 v : POSITION, float4 w : NORMAL) : SV_Position {
  float4x4 m = 0;
  m._11_22.yx = v.xy;
  m._m03_m12_m21.zx += w.zw;
  m._13_24[1] = v.z;
  m._31_42[0] *= w.y;
  float s;
  sincos(v.w, s, m._m33);
  sincos(w.xy, m._m20_m32, m._m31_m02);
  return mul(m, w) + m._11_22.yxyx + m[0] + m[3] * s;
}
