// Bit-fields are fields of structs only: [class.bit] of C++, and dxc expects a semantic. fxc has none at all.
// RUN: not %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s
cbuffer Constants {
  // CHECK: [[#@LINE+1]]:15: error: a number after `:` makes a bit-field, which only a struct has; here a semantic or `register(...)` follows `:` [bit-field-misplaced]
  uint part : 3;
};
// CHECK: [[#@LINE+1]]:15: error: a number after `:` makes a bit-field
uint global : 3 = 9;
// CHECK: [[#@LINE+1]]:47: error: a number after `:` makes a bit-field
float4 main(float4 p : POSITION, uint given : 5) : SV_Position {
  // CHECK: [[#@LINE+1]]:16: error: a number after `:` makes a bit-field
  uint local : 2 = 9;
  return p * (part + global + local);
}
