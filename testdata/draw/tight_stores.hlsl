// Elements that lie tighter in Direct3D than std430 has them are written and read word by word. Oracle: a structured buffer's stride is
// the sum of its components ("Structured Buffer" of the Direct3D 11.3 functional specification).
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,vulkan
// RUN: %draw compare %s -T vs_5_0 --target=essl310 --lower=none
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
struct Node {
  float4 color;
  float depth;
  uint next;
};
RWStructuredBuffer<Node> nodes : register(u0);
RWStructuredBuffer<float3> normals : register(u1);
struct Output {
  float4 position : SV_Position;
  float4 color : COLOR;
  float3 normal : NORMAL;
  nointerpolation int2 rest : REST;
};
// CHECK: void nodes_store_at(int i, Node value) {
// CHECK-NEXT: nodes[6 * i] = floatBitsToUint(value.color.x);
// CHECK: nodes[6 * i + 4] = floatBitsToUint(value.depth);
// CHECK-NEXT: nodes[6 * i + 5] = value.next;
Output main(float4 p : POSITION, uint id : SV_VertexID) {
  Output o;
  Node node;
  node.color = p;
  node.depth = p.x * 2;
  node.next = id + 3;
  // CHECK: nodes_store_at(
  nodes[id] = node;
  normals[id] = p.zyx;
  o.position = p;
  o.color = nodes[id].color * nodes[id].depth;
  o.normal = normals[id];
  o.rest = int2(nodes[id].next, 1);
  return o;
}
