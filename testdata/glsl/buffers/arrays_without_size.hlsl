// Arrays of textures, samplers and buffers without a size, on Vulkan. An index that NonUniformResourceIndex names says so where it
// chooses, also after it went through variables and parameters. What is not read needs nothing.
// RUN: %clipc -T vs_5_1 --target=vulkan --validate %s -o - --reflect=%t.json | FileCheck %s
// RUN: %clipc -T vs_5_1 --target=vulkan %s -o %t.spv
// RUN: FileCheck %s --check-prefix=REFLECT < %t.json
// RUN: %clipc -T vs_5_1 --target=glsl450 -DUNREAD --validate %s -o %t.vert
// REFLECT: "name": "views"
// REFLECT: "unbounded": true
// REFLECT: "name": "maps"
// REFLECT: "type": "Texture2D<float4>[]",
// REFLECT: "unbounded": true
// AUTOUPDATE
Texture2D maps[] : register(t0, space1);
Texture2D<uint4> numbers[] : register(t0, space2);
StructuredBuffer<float4> lists[] : register(t0, space3);
struct Loose { float3 place; float weight; float3 normal; };
StructuredBuffer<Loose> loose[] : register(t0, space4);
ByteAddressBuffer bytes[] : register(t0, space5);
Buffer<float4> typed[] : register(t0, space6);
SamplerState states[] : register(s0, space1);
struct Camera { float4x4 view; float4 plane; };
ConstantBuffer<Camera> cameras[4] : register(b2);
ConstantBuffer<Camera> views[] : register(b0, space8);
struct Tight { float weight; float3 place; float2 size; float3 normal; };
ConstantBuffer<Tight> tight[] : register(b0, space9);
ConstantBuffer<Camera> spare[] : register(b0, space10);
StructuredBuffer<float4> sized[4] : register(t9);
Texture2D unread[];
RWStructuredBuffer<float4> written[] : register(u0, space7);

float4 Read(Texture2D map, float2 uv) { return map.SampleLevel(states[2], uv, 0); }

float4 main(float4 p : POSITION, uint i : SV_VertexID) : SV_Position {
#ifdef UNREAD
  return p;
#else
  i &= 3;
  uint n = NonUniformResourceIndex(i);
  Camera camera = cameras[NonUniformResourceIndex(i)];
  float4 r = Read(maps[n], p.xy) + maps[2].SampleLevel(states[n], p.xy, 0) + Read(maps[1], p.xy);
  r += numbers[NonUniformResourceIndex(i)].Load(int3(0, 0, 0)) + lists[n][i] + lists[(n + 1) & 3][i].x * lists[1][2];
  r += loose[n][i].normal.xyzz + loose[1][i].normal.xyzz + bytes[n].Load4(i * 16) % 64 + bytes[2].Load(4) % 64;
  uint count, stride;
  lists[n].GetDimensions(count, stride);
  r += typed[n][i] + mul(p, cameras[n].view) + camera.plane + sized[n][2] + count;
  Camera view = views[n];
  r += view.plane + mul(p, views[2].view) + tight[n].normal.xyzz;
#ifdef WRITE
  written[n][0] = r;
#endif
  return r;
#endif
}

// CHECK: #version 460
// CHECK-NEXT: #extension GL_EXT_nonuniform_qualifier : require
// CHECK-NEXT: #extension GL_EXT_samplerless_texture_functions : require
// CHECK-EMPTY:
// CHECK-NEXT: struct Tight {
// CHECK-NEXT:     float weight;
// CHECK-NEXT:     vec3 place;
// CHECK-NEXT:     vec2 size;
// CHECK-NEXT:     vec3 normal;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct Camera {
// CHECK-NEXT:     mat4 view;
// CHECK-NEXT:     vec4 plane;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct Loose {
// CHECK-NEXT:     vec3 place;
// CHECK-NEXT:     float weight;
// CHECK-NEXT:     vec3 normal;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, set = 0, binding = 2) uniform cameras_block {  // b2
// CHECK-NEXT:     layout(row_major) mat4 view;
// CHECK-NEXT:     vec4 plane;
// CHECK-NEXT: } cameras[4];
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, set = 8, binding = 0) uniform views_block {  // b0, space8
// CHECK-NEXT:     layout(row_major) mat4 view;
// CHECK-NEXT:     vec4 plane;
// CHECK-NEXT: } views[];
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, set = 9, binding = 0) uniform tight_block {  // b0, space9
// CHECK-NEXT:     vec4 tight_rows[3];
// CHECK-NEXT: } tight_buffers[];
// CHECK-EMPTY:
// CHECK-NEXT: layout(set = 1, binding = 32) uniform texture2D maps[];  // t0
// CHECK-NEXT: layout(set = 2, binding = 32) uniform utexture2D numbers[];  // t0
// CHECK-NEXT: layout(std430, set = 3, binding = 32) readonly buffer lists_block {  // t0
// CHECK-NEXT:     vec4 elements[];
// CHECK-NEXT: } lists[];
// CHECK-NEXT: layout(std430, set = 4, binding = 32) readonly buffer loose_block {  // t0
// CHECK-NEXT:     uint elements[];
// CHECK-NEXT: } loose[];
// CHECK-NEXT: layout(std430, set = 5, binding = 32) readonly buffer bytes_block {  // t0
// CHECK-NEXT:     uint elements[];
// CHECK-NEXT: } bytes[];
// CHECK-NEXT: layout(set = 6, binding = 32) uniform textureBuffer typed[];  // t0
// CHECK-NEXT: layout(set = 1, binding = 16) uniform sampler states[];  // s0
// CHECK-NEXT: layout(std430, set = 0, binding = 41) readonly buffer sized_block {  // t9
// CHECK-NEXT:     vec4 elements[];
// CHECK-NEXT: } sized[4];
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: Tight tight(int i) {  // offset 0
// CHECK-NEXT:     return Tight(tight_buffers[i].tight_rows[0].x, tight_buffers[i].tight_rows[0].yzw, tight_buffers[i].tight_rows[1].xy, tight_buffers[i].tight_rows[2].xyz);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Camera cameras_any_value(uint i_2) {
// CHECK-NEXT:     return Camera(cameras[nonuniformEXT(i_2)].view, cameras[nonuniformEXT(i_2)].plane);
// CHECK-NEXT: }
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
// CHECK-NEXT: uint bytes_load(int which, uint address) {
// CHECK-NEXT:     uint i_2 = address / 4u;
// CHECK-NEXT:     return bytes[which].elements[i_2];
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Camera views_any_value(uint i_2) {
// CHECK-NEXT:     return Camera(views[nonuniformEXT(i_2)].view, views[nonuniformEXT(i_2)].plane);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Read(vec2 uv, uint maps_index) {
// CHECK-NEXT:     return textureLod(sampler2D(maps[nonuniformEXT(maps_index)], states[2]), uv, 0.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Read(vec2 uv) {
// CHECK-NEXT:     return textureLod(sampler2D(maps[1], states[2]), uv, 0.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint i = uint(gl_VertexIndex - gl_BaseVertex);
// CHECK-NEXT:     i &= 3u;
// CHECK-NEXT:     uint n = i;
// CHECK-NEXT:     Camera camera = cameras_any_value(i);
// CHECK-NEXT:     gl_Position = Read(in_POSITION0.xy, n) + textureLod(sampler2D(maps[2], states[nonuniformEXT(n)]), in_POSITION0.xy, 0.0) + Read(in_POSITION0.xy);
// CHECK-NEXT:     gl_Position += vec4(texelFetch(numbers[nonuniformEXT(i)], ivec2(0), 0)) + lists[nonuniformEXT(n)].elements[i] + lists[nonuniformEXT((n + 1u) & 3u)].elements[i].x * lists[1].elements[2];
// CHECK-NEXT:     gl_Position += loose_any_at(n, int(i)).normal.xyzz + loose_at(1, int(i)).normal.xyzz + vec4(bytes_any_load4(n, i * 16u) % 64u) + float(bytes_load(2, 4u) % 64u);
// CHECK-NEXT:     uint count;
// CHECK-NEXT:     count = uint(lists[nonuniformEXT(n)].elements.length());
// CHECK-NEXT:     gl_Position += texelFetch(typed[nonuniformEXT(n)], int(i)) + cameras[nonuniformEXT(n)].view * in_POSITION0 + camera.plane + sized[nonuniformEXT(n)].elements[2] + float(count);
// CHECK-NEXT:     Camera view = views_any_value(n);
// CHECK-NEXT:     gl_Position += view.plane + views[2].view * in_POSITION0 + tight(int(nonuniformEXT(n))).normal.xyzz;
// CHECK-NEXT: }
