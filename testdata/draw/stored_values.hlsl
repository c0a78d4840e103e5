// An assignment to an element of an unordered access view has the value that is stored, and an element is an out argument: the call
// writes a copy, which is then stored. Oracle: glslang takes both (its test hlsl.rw.bracket).
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,vulkan
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
RWStructuredBuffer<float4> numbers : register(u0);
RWStructuredBuffer<uint> counts : register(u1);
void fill(out float4 v, float4 p) { v = p * 2; }
void more(inout float4 v) { v += 1; }
struct Output {
  float4 position : SV_Position;
  float4 a : A;
  float4 b : B;
  nointerpolation uint2 c : C;
};
Output main(float4 p : POSITION, uint id : SV_VertexID) {
  Output o;
  const uint i = 4 * id;
  o.position = p;
  o.a = numbers[i] = p.wzyx;
  o.b = (numbers[i] *= 2) + (numbers[i].x += 3);
  o.c.x = counts[i] = counts[i + 1] = id + 1;
  fill(numbers[i + 1], p);
  more(numbers[i + 1]);
  o.a += numbers[i + 1];
  o.b += numbers[i];
  o.c.y = counts[i + 1];
  // A statement stores its value itself.
  // CHECK: numbers[{{.*}} + 2{{.*}}] = in_POSITION0;
  numbers[i + 2] = p;
  return o;
}
