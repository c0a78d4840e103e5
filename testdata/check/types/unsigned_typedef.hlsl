// `unsigned` before a typedef of integers makes their unsigned type, as DXC's ApplyTypeSpecSignToParsedType; in front of every other type it
// is an error (fxc X3085, DXC's matrix-syntax.hlsl).
// RUN: %clipc -T vs_5_0 %s -o - | FileCheck %s
// RUN: %clipc -T vs_6_0 %s -o - | FileCheck %s
typedef int index_t;
typedef int2 pair_t;
// CHECK: uint twice(uint a) {
unsigned index_t twice(unsigned index_t a) { return a * 2; }
// CHECK: void main() {
float4 main(uint i : I, float4 p : POSITION) : SV_Position {
  // CHECK: uint high = in_I0;
  unsigned index_t high = i;
  // CHECK: uvec2 both
  unsigned pair_t both = pair_t(-1, 3);
  return p * twice(high >> 31) * both.x;
}
