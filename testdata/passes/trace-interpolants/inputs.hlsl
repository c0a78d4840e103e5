// An input is evaluated at another place where the entry function keeps its call, and in functions, structs and arrays that carry the
// input: fxc and dxc inline all of them. A value that is written a second time is not the input.
// RUN: %clipc -T ps_6_1 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_1 --target=vulkan --validate %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_1 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_6_1 -E vertices --target=vulkan --validate --verify %s -o - | FileCheck %s --check-prefix=VERTICES
struct Part {
  float4 color : COLOR;
};
struct Input {
  float4 position : SV_Position;
  float2 uv : UV;
  float2 pair[2] : PAIR;
  Part part;
};

// CHECK: interpolateAtCentroid(vs_COLOR0)
float4 OfStruct(Input whole) { return EvaluateAttributeCentroid(whole.part.color); }
// CHECK: vec2 AtSample(vec2 x) {
// CHECK-NEXT: return interpolateAtSample(vs_UV0, int(1u));
float2 AtSample(float2 x) { return EvaluateAttributeAtSample(x, 1); }

// CHECK: interpolateAtOffset(vs_PAIR1,
// CHECK: interpolateAtCentroid(vs_UV0)
float4 main(Input input) : SV_Target {
  if (input.uv.x > 3)
    return 1;
  Input copy = input;
  float4 sum = OfStruct(copy);
  sum.xy += AtSample(input.uv) + EvaluateAttributeSnapped(input.pair[1], int2(1, 2));
  return sum + EvaluateAttributeCentroid(copy.uv).xyxy;
}

// VERTICES: return vs_FLAT0[1u];
float4 Second(nointerpolation float4 value) { return GetAttributeAtVertex(value, 1); }
float4 vertices(nointerpolation float4 flat_value : FLAT) : SV_Target {
  if (flat_value.x > 3)
    return GetAttributeAtVertex(flat_value, 0);
  return Second(flat_value);
}
