// Swizzles of matrix swizzles and their elements are assigned to as the components that they name;
// functions write into them as well.
// RUN: %clipc -T vs_5_0 %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
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

// CHECK: void main() {
// CHECK-NEXT:     mat4 m = mat4(0.0);
// CHECK-NEXT:     vec2 temporary = in_POSITION0.xy;
// CHECK-NEXT:     m[1][1] = temporary.x;
// CHECK-NEXT:     m[0][0] = temporary.y;
// CHECK-NEXT:     vec2 temporary_2 = vec2(m[2][1], m[0][3]) + in_NORMAL0.zw;
// CHECK-NEXT:     m[2][1] = temporary_2.x;
// CHECK-NEXT:     m[0][3] = temporary_2.y;
// CHECK-NEXT:     m[1][3] = in_POSITION0.z;
// CHECK-NEXT:     m[2][0] *= in_NORMAL0.y;
// CHECK-NEXT:     float s;
// CHECK-NEXT:     sincos(in_POSITION0.w, s, m[3][3]);
// CHECK-NEXT:     vec2 temporary_3 = vec2(0.0);
// CHECK-NEXT:     vec2 temporary_4 = vec2(0.0);
// CHECK-NEXT:     sincos(in_NORMAL0.xy, temporary_3, temporary_4);
// CHECK-NEXT:     m[2][0] = temporary_3.x;
// CHECK-NEXT:     m[3][2] = temporary_3.y;
// CHECK-NEXT:     m[3][1] = temporary_4.x;
// CHECK-NEXT:     m[0][2] = temporary_4.y;
// CHECK-NEXT:     gl_Position = in_NORMAL0 * m + vec4(m[1][1], m[0][0], m[1][1], m[0][0]) + m[0] + m[3] * s;
// CHECK-NEXT: }
