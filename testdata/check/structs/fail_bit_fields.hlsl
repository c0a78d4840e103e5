// What dxc refuses of bit-fields, and what clipc does not support, is an error. Oracle: the errors of Clang and dxc that bear the names
// err_bitfield_width_exceeds_type_size, err_bitfield_has_zero_width, err_hlsl_bitfields_with_annotation and err_hlsl_bitfields.
// RUN: not %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_6_0 -HV 2018 -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=OLD
struct Wrong {
  // CHECK: [[#@LINE+2]]:15: error: `wide` has 33 bits; a bit-field has 1 to 32 [bit-field-width]
  // OLD: [[#@LINE+1]]:15: error: bit-fields come with HLSL 2021; this is HLSL 2018 [language-needed]
  uint wide : 33;
  // CHECK: [[#@LINE+1]]:16: error: `empty` has 0 bits; a bit-field has 1 to 32 [bit-field-width]
  uint empty : 0;
  // CHECK: [[#@LINE+1]]:16: error: `real` has type `float`; a bit-field is an `int` or a `uint` [bit-field-type]
  float real : 3;
  // CHECK: [[#@LINE+1]]:19: error: `named` is a bit-field; a bit-field has no semantic, register or `packoffset` [bit-field-annotated]
  int named : 3 : NAMED;
  int small : 3;
  // CHECK: [[#@LINE+1]]:16: error: bit-fields of `int` and `uint` share 32 bits; dxc places such bit-fields otherwise for Direct3D than for Vulkan; write `int : 0;` between them [bit-fields-mixed]
  uint other : 4;
};
struct Bits {
  uint a : 3;
  uint b : 4;
};
struct Plain {
  uint a;
};
void Write(out uint value) { value = 1; }
float4 main(float4 p : POSITION) : SV_Position {
  Wrong wrong;
  Bits bits;
  Plain plain = {1};
  // CHECK: [[#@LINE+1]]:10: error: a conversion between `Plain` and `Bits`, of which one has bit-fields, is not supported [unsupported]
  bits = (Bits)plain;
  // CHECK: [[#@LINE+1]]:9: error: this cannot be assigned to; a variable, a member or components of one can [not-assignable, X3025]
  Write(bits.a);
  return p * bits.a * wrong.small;
}
