// Constant buffers whose members lie where no block of Vulkan has them, in the last row of an array or a struct: rows of words, out of which
// values are put together. Arrays of constant buffers, of one dimension in the module.
// RUN: %clipc -T vs_5_1 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_1 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T vs_5_1 -spirv -fspv-target-env=vulkan1.0 %s -o %t.spv && spirv-val --target-env vulkan1.0 %t.spv
// RUN: %clipc -T vs_5_1 -spirv -fspv-target-env=vulkan1.3 %s -o %t.spv && spirv-val --target-env vulkan1.3 %t.spv
// RUN: %clipc -T vs_5_1 -E buffers -spirv -S %s -o - | FileCheck %s --check-prefix=BUFFERS
// RUN: %clipc -T vs_5_1 -E buffers -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T vs_5_1 -E doubles -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %draw compare %s -T vs_5_1 --target vulkan --ints 0..2
struct Light {
  float3 color;
  float2 range[2];
};
cbuffer Frame : register(b1) {
  Light lights[3];
  float last;
  bool2 is_lit[3];
  uint after;
  float3x2 turn;
  float beside;
  row_major int2x3 numbers;
  int3 cells;
};

// CHECK: OpMemberName %Frame 0 "rows"
// CHECK: OpDecorate %_arr_v4uint_uint_{{[0-9]+}} ArrayStride 16
// CHECK: OpLoad %v4uint
struct Output {
  float4 position : SV_Position;
  float4 a : A;
  float4 b : B;
};
Output main(float4 p : POSITION, uint i : I, uint k : K) {
  const Light light = lights[i];
  Output o;
  o.position = float4(light.color, light.range[k & 1].y) + p * last;
  o.a = float4(lights[k].range[1], turn[i]) + float4(turn[k & 1][i & 1], beside, numbers[k & 1].zx) + after % 7;
  o.a.xyz += mul(turn, p.xy) + cells[k] + (is_lit[i][k & 1] ? 1 : 2);
  o.b = float4(mul(p.xy, (float2x3)numbers), lights[2].color[k]);
  o.b.zw += is_lit[1] ? lights[i].range[0].yx : p.zw;
  return o;
}

struct Part {
  float4 scale;
  float2 shift;
};
// BUFFERS: OpCapability UniformBufferArrayNonUniformIndexing
ConstantBuffer<Part> parts[2][3] : register(b4);
// BUFFERS: OpDecorate %[[BLOCK:Part_[0-9]+]] Block
// BUFFERS: OpTypeArray %[[BLOCK]] %uint_6
// BUFFERS: OpIMul %int
float4 buffers(float4 p : POSITION, uint i : I) : SV_Position {
  const Part one = parts[1][2];
  return p * parts[NonUniformResourceIndex(i & 1)][i % 3].scale + one.scale + parts[0][i % 3].shift.xyxy;
}

cbuffer Doubles : register(b5) {
  double exact[2];
  double3 wide;
};
float4 doubles(float4 p : POSITION, uint i : I) : SV_Position { return p * (float)exact[i & 1] + (float)wide.z + (float)wide.x; }
