// Arrays without a size, drawn: buffers at indices that differ from vertex to vertex, textures at constant ones, since Mesa 22.3's
// lavapipe takes the first vertex's element of textures whose number it does not know, of constant buffers and of sizes.
// RUN: %clipc -T vs_5_1 --target=vulkan --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_1 --target vulkan
// AUTOUPDATE
Texture2D maps[] : register(t0, space1);
Texture2D few[4] : register(t0, space2);
StructuredBuffer<float4> lists[] : register(t0, space3);
struct Loose { float3 place; float weight; float3 normal; };
StructuredBuffer<Loose> loose[] : register(t0, space4);
ByteAddressBuffer bytes[] : register(t0, space5);
SamplerState state;

float4 Read(Texture2D map, StructuredBuffer<float4> list, float2 uv, uint i) { return map.SampleLevel(state, uv, 0) * list[i]; }

float4 main(float4 p : POSITION, uint i : SV_VertexID) : SV_Position {
  i &= 3;
  uint n = NonUniformResourceIndex(i);
  float4 r = Read(maps[3], lists[n], p.xy, i) + maps[0].SampleLevel(state, p.xy, 0) + Read(few[n], lists[2], p.xy, i);
  r += loose[n][i].normal.xyzz + loose[1][i].normal.xyzz + bytes[n].Load4(i * 16) % 64;
  return r;
}

// CHECK: #version 460
// CHECK-NEXT: #extension GL_EXT_nonuniform_qualifier : require
// CHECK-EMPTY:
// CHECK-NEXT: struct Loose {
// CHECK-NEXT:     vec3 place;
// CHECK-NEXT:     float weight;
// CHECK-NEXT:     vec3 normal;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(set = 1, binding = 32) uniform texture2D maps[];  // t0
// CHECK-NEXT: layout(set = 2, binding = 32) uniform texture2D few[4];  // t0
// CHECK-NEXT: layout(std430, set = 3, binding = 32) readonly buffer lists_block {  // t0
// CHECK-NEXT:     vec4 elements[];
// CHECK-NEXT: } lists[];
// CHECK-NEXT: layout(std430, set = 4, binding = 32) readonly buffer loose_block {  // t0
// CHECK-NEXT:     uint elements[];
// CHECK-NEXT: } loose[];
// CHECK-NEXT: layout(std430, set = 5, binding = 32) readonly buffer bytes_block {  // t0
// CHECK-NEXT:     uint elements[];
// CHECK-NEXT: } bytes[];
// CHECK-NEXT: layout(set = 0, binding = 16) uniform sampler state;  // s0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: Loose loose_any_at(uint which, int i_2) {
// CHECK-NEXT:     return Loose(uintBitsToFloat(uvec3(loose[nonuniformEXT(which)].elements[7 * i_2], loose[nonuniformEXT(which)].elements[7 * i_2 + 1], loose[nonuniformEXT(which)].elements[7 * i_2 + 2])), uintBitsToFloat(loose[nonuniformEXT(which)].elements[7 * i_2 + 3]), uintBitsToFloat(uvec3(loose[nonuniformEXT(which)].elements[7 * i_2 + 4], loose[nonuniformEXT(which)].elements[7 * i_2 + 5], loose[nonuniformEXT(which)].elements[7 * i_2 + 6])));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Loose loose_at(int which, int i_2) {
// CHECK-NEXT:     return Loose(uintBitsToFloat(uvec3(loose[which].elements[7 * i_2], loose[which].elements[7 * i_2 + 1], loose[which].elements[7 * i_2 + 2])), uintBitsToFloat(loose[which].elements[7 * i_2 + 3]), uintBitsToFloat(uvec3(loose[which].elements[7 * i_2 + 4], loose[which].elements[7 * i_2 + 5], loose[which].elements[7 * i_2 + 6])));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: uvec4 bytes_any_load4(uint which, uint address) {
// CHECK-NEXT:     uint i_2 = address / 4u;
// CHECK-NEXT:     return uvec4(bytes[nonuniformEXT(which)].elements[i_2], bytes[nonuniformEXT(which)].elements[i_2 + 1u], bytes[nonuniformEXT(which)].elements[i_2 + 2u], bytes[nonuniformEXT(which)].elements[i_2 + 3u]);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Read(vec2 uv, uint i, uint lists_index) {
// CHECK-NEXT:     return textureLod(sampler2D(maps[3], state), uv, 0.0) * lists[nonuniformEXT(lists_index)].elements[i];
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Read_2(vec2 uv, uint i, uint few_index) {
// CHECK-NEXT:     return textureLod(sampler2D(few[nonuniformEXT(few_index)], state), uv, 0.0) * lists[2].elements[i];
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint i = uint(gl_VertexIndex - gl_BaseVertex);
// CHECK-NEXT:     i &= 3u;
// CHECK-NEXT:     uint n = i;
// CHECK-NEXT:     gl_Position = Read(in_POSITION0.xy, i, n) + textureLod(sampler2D(maps[0], state), in_POSITION0.xy, 0.0) + Read_2(in_POSITION0.xy, i, n);
// CHECK-NEXT:     gl_Position += loose_any_at(n, int(i)).normal.xyzz + loose_at(1, int(i)).normal.xyzz + vec4(bytes_any_load4(n, i * 16u) % 64u);
// CHECK-NEXT: }
