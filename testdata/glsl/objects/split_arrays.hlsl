// dxc's -fspv-flatten-resource-arrays: each element of an array is a resource with a binding of its own, as in Direct3D. The oracle is
// the text on it in DXC's docs/SPIR-V.rst. What keeps one binding is said: an array without a size, with counters, or of buffers of
// constants.
// RUN: %clipc -T ps_6_0 %s --target=vulkan -fspv-flatten-resource-arrays -Wno-object-index-varies -o %t.frag --reflect=%t.json 2> %t.err
// RUN: FileCheck %s < %t.frag
// RUN: FileCheck %s --check-prefix=SAID --implicit-check-not=warning: < %t.err
// RUN: FileCheck %s --check-prefix=JSON < %t.json
// RUN: %clipc -T ps_6_0 %s -spirv -fspv-flatten-resource-arrays -w -o %t.spv
// RUN: %clipc -T ps_6_0 %s --target=vulkan --flatten-uniform-arrays -w -o - | FileCheck %s
// RUN: %clipc -T ps_6_0 %s --target=vulkan -w -o - | FileCheck %s --check-prefix=WHOLE
// CHECK-DAG: binding = 291) uniform texture2D maps_2;  // t3
// CHECK-DAG: binding = 289) uniform texture2D maps_0;  // t1
// CHECK-DAG: binding = 274) uniform sampler samplers_1;  // s2
// CHECK-DAG: binding = 300) uniform texture2D grid_2;  // t12
// CHECK-DAG: binding = 418) buffer written_1_block {  // u2
// CHECK-DAG: binding = 308) uniform texture2D one_0;  // t20
// CHECK-DAG: binding = 288) uniform texture2D endless[];
// CHECK-DAG: } counted[2];
// CHECK: texture(sampler2D(maps_2, samplers_1), vs_UV0)
// WHOLE: binding = 289) uniform texture2D maps[3];
// JSON:  "binding": 291,
// JSON:  "name": "maps_2",
// SAID: warning: `-fspv-flatten-resource-arrays` has no effect: the array `counted` keeps its one binding
// SAID: warning: `-fspv-flatten-resource-arrays` has no effect: the array `endless` keeps its one binding
// SAID: warning: `-fspv-flatten-resource-arrays` has no effect: the array `tints` keeps its one binding
struct Tint { float4 color; };
Texture2D maps[3] : register(t1);
SamplerState samplers[2] : register(s1);
Texture2D grid[2][2] : register(t10);
RWStructuredBuffer<float4> written[2] : register(u1);
AppendStructuredBuffer<float4> counted[2] : register(u5);
Texture2D one[1] : register(t20);
Texture2D endless[] : register(t0, space1);
ConstantBuffer<Tint> tints[2] : register(b0);
float4 main(float2 uv : UV, nointerpolation uint i : INDEX) : SV_Target {
  written[1][0] = 1;
  counted[0].Append(uv.xyxy);
  float4 sum = maps[2].Sample(samplers[1], uv) + maps[0].Sample(samplers[0], uv) + grid[1][0].Sample(samplers[1], uv);
  return sum + one[0].Load(0) + endless[i].Load(0) + tints[1].color;
}
