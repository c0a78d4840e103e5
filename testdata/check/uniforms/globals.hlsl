// Uniforms outside any cbuffer are $Globals, those of the entry point $Params. Only what is reached is in the program, but a
// buffer is there with all its members.
// RUN: %clipc -T vs_5_1 -E main --dump=ir %s | FileCheck %s
// RUN: %clipc -T vs_5_1 -E main -Zpr --dump=ir %s | FileCheck %s --check-prefix=ROW
// RUN: %clipc -T vs_5_1 -E main %s -o - 2>&1 | FileCheck %s --check-prefix=WARN
float scale = 2;
row_major float4x3 row;
column_major float4x3 column;
// WARN: warning: the value of `limit` is not used; a global that is `const` but not `static` is set by the application [-Wconst-global-is-uniform]
const int limit = 3;
float list[limit] : register(c8);
Texture2D unused_texture;
cbuffer Unused { float4 unused; };
cbuffer Used : register(b5, space2) { float4 first; float other : packoffset(c7.y); };
struct Light { float3 direction; float power; };
ConstantBuffer<Light> light : register(b1);
ConstantBuffer<Light> lights[3];
tbuffer Table { float4 entry; };
// CHECK: globals $Globals : b0, {{[0-9]+}} bytes {
// CHECK-NEXT: float scale at 164, 4 bytes
// CHECK-NEXT: row_major float4x3 row at 176, 60 bytes
// CHECK-NEXT: float4x3 column at 240, 48 bytes
// CHECK-NEXT: int limit at
// CHECK-NEXT: float list[3] at 128, 36 bytes explicit
// CHECK-NOT: Unused
// CHECK: cbuffer Used : b5, space2 explicit, 144 bytes {
// CHECK: float other at 116, 4 bytes explicit
// CHECK: constant_buffer light : b1 explicit, 16 bytes {
// CHECK: constant_buffer lights : b3, 16 bytes x 3 {
// CHECK: tbuffer Table : t0
// CHECK: params $Params : b2
// CHECK-NEXT: float4x4 {{by_entry.*}} at 0
// ROW: row_major float4x4 {{by_entry.*}} at 0
// CHECK-NOT: unused
float4 main(float4 v : POSITION, uniform float4x4 by_entry) : SV_Position {
  v += mul(v, by_entry) * scale * limit * list[1];
  return v * other * light.power * lights[2].power * entry;
}
