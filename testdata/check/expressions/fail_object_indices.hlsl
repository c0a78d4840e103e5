// An index has a component for each dimension of the object: DXC's indexing-operator.hlsl has what
// fxc says of each.
// RUN: not %clipc -T vs_5_0 %s 2>&1 | grep -v '^ ' | FileCheck %s
Buffer<float4> typed;
StructuredBuffer<float4> structured;
Texture1D line_;
Texture2D picture;
Texture2DArray pictures;
float4 main(float4 p : POSITION, int1 i : I) : SV_Position {
  // CHECK: [[#@LINE+1]]:14: error: the index has type `uint2`; it must be `int` [object-index-type, X3120]
  p += typed[uint2(1, 2)];
  // CHECK-NEXT: [[#@LINE+1]]:19: error: the index has type `int2`; it must be `int`
  p += structured[int2(1, 2)];
  // CHECK-NEXT: [[#@LINE+1]]:14: error: the index has type `int2`; it must be `int`
  p += line_[int2(1, 2)];
  // CHECK-NEXT: [[#@LINE+1]]:16: error: the index has type `int3`; it must be `int2`
  p += picture[int3(1, 2, 3)];
  // CHECK-NEXT: [[#@LINE+1]]:24: error: the index has type `int2x2`; it must be `int2`
  p += picture.mips[0][int2x2(1, 2, 3, 4)];
  // CHECK-NEXT: [[#@LINE+1]]:17: error: the index has type `int2`; it must be `int3`
  p += pictures[int2(1, 2)];
  return p + typed[i] + line_[1.5] + pictures[uint3(1, 2, 3)];
}
// CHECK-NOT: {{error|warning}}
