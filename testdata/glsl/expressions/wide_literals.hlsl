// An integer with `ull` is 64 wide; a shift of one takes its count modulo 64.
// RUN: %clipc -T vs_6_0 --target=glsl450 --validate %s -o - | FileCheck %s
// AUTOUPDATE
float4 main(float4 p : POSITION, uint id : ID) : SV_Position {
  uint64_t wide = 4294967296ull * id;
  uint64_t again = wide;
  again >>= 33;
  return p * float(wide >> 32) * float(again);
}

// CHECK: #version 450
// CHECK-NEXT: #extension GL_ARB_gpu_shader_int64 : require
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in uint in_ID0;  // id : ID0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint64_t wide = 4294967296ul * uint64_t(in_ID0);
// CHECK-NEXT:     uint64_t again = wide;
// CHECK-NEXT:     again >>= 33;
// CHECK-NEXT:     gl_Position = in_POSITION0 * float(wide >> 32) * float(again);
// CHECK-NEXT: }
