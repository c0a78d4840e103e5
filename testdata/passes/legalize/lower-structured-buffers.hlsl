// Elements that lie tighter than std430 can say are put together from words, and stored word by word. What fits std430 stays. A
// function fills a long array; it has the buffer's place in an array of buffers too.
// RUN: %clipc -T vs_6_0 --target=vulkan --verify --dump-after=lower-structured-buffers --stop-after=lower-structured-buffers %s | FileCheck %s
// RUN: %draw compare %s -T vs_6_0 --target vulkan --lower none --ints 0..1
// AUTOUPDATE
struct Tight {
  float3 place;
  bool seen;
  float weights[20];
  float3x2 turned;
  row_major int2x3 rows;
  float3x1 column;
  half small;
};
StructuredBuffer<Tight> lists[2] : register(t0);
StructuredBuffer<float4> fits : register(t2);
RWStructuredBuffer<float3> normals : register(u0);

float4 main(float4 p : POSITION, uint id : SV_VertexID, int i : INDEX) : SV_Position {
  uint count, stride;
  normals.GetDimensions(count, stride);
  normals[id] = p.xyz;
  normals[id].yz = p.zw;
  normals[id][i] = 2;
  Tight tight = lists[1][i];
  return p * tight.weights[i] + mul(tight.turned, p.xy).xyzz + tight.rows[1][2] + tight.column._21 + fits[i] + count + tight.place.xyzz * tight.small +
         normals[id].xyzz;
}

// CHECK: program vs_6_0 form legalized
// CHECK-NEXT: struct Tight {
// CHECK-NEXT:   float3 place
// CHECK-NEXT:   bool seen
// CHECK-NEXT:   float weights[20]
// CHECK-NEXT:   float3x2 turned
// CHECK-NEXT:   row_major int2x3 rows
// CHECK-NEXT:   float3x1 column
// CHECK-NEXT:   half small
// CHECK-NEXT: }
// CHECK-NEXT: resource StructuredBuffer<uint> lists[2] : t0 explicit
// CHECK-NEXT: resource StructuredBuffer<float4> fits : t2 explicit
// CHECK-NEXT: resource RWStructuredBuffer<uint> normals : u0 explicit
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: input uint in_SV_VERTEXID0 : SV_VertexID0 builtin vertex_id
// CHECK-NEXT: input int in_INDEX0 : INDEX0 location 1
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   uint id = in_SV_VERTEXID0
// CHECK-NEXT:   uint count
// CHECK-NEXT:   count = convert<uint>(buffer_size(normals) / 3)
// CHECK-NEXT:   normals_store_at(convert<int>(id), in_POSITION0.xyz)
// CHECK-NEXT:   normals_store1_at(convert<int>(id), in_POSITION0.zw)
// CHECK-NEXT:   normals_store_part_at(convert<int>(id), in_INDEX0, 2.0)
// CHECK-NEXT:   Tight tight = lists_at(1, in_INDEX0)
// CHECK-NEXT:   vs_SV_POSITION0 = (((((((in_POSITION0 * splat<float4>(tight.weights[in_INDEX0])) + mul(tight.turned, in_POSITION0.xy).xyzz) + splat<float4>(convert<float>(tight.rows[1][2]))) + splat<float4>(tight.column[1u][0u])) + structured_load(fits, in_INDEX0)) + splat<float4>(convert<float>(count))) + (tight.place.xyzz * splat<float4>(convert<float>(tight.small)))) + normals_at(convert<int>(id)).xyzz
// CHECK-NEXT: }
// CHECK-NEXT: helper void normals_store_at(int i.1, float3 value) {
// CHECK-NEXT:   store(normals, 3 * i.1, value: asuint(value.x))
// CHECK-NEXT:   store(normals, (3 * i.1) + 1, value: asuint(value.y))
// CHECK-NEXT:   store(normals, (3 * i.1) + 2, value: asuint(value.z))
// CHECK-NEXT: }
// CHECK-NEXT: helper void normals_store1_at(int i.2, float2 value.1) {
// CHECK-NEXT:   store(normals, (3 * i.2) + 1, value: asuint(value.1.x))
// CHECK-NEXT:   store(normals, (3 * i.2) + 2, value: asuint(value.1.y))
// CHECK-NEXT: }
// CHECK-NEXT: helper void normals_store_part_at(int i.3, int word, float value.2) {
// CHECK-NEXT:   store(normals, (3 * i.3) + word, value: asuint(value.2))
// CHECK-NEXT: }
// CHECK-NEXT: helper float[20] load_lists(int which.1, int at) {
// CHECK-NEXT:   float result.1[20]
// CHECK-NEXT:   for (int i.5 = 0; i.5 < 20; ++i.5) {
// CHECK-NEXT:     result.1[i.5] = asfloat(structured_load(lists[which.1], at + i.5))
// CHECK-NEXT:   }
// CHECK-NEXT:   return result.1
// CHECK-NEXT: }
// CHECK-NEXT: helper Tight lists_at(int which, int i.4) {
// CHECK-NEXT:   return Tight{asfloat(uint3(structured_load(lists[which], 40 * i.4), structured_load(lists[which], (40 * i.4) + 1), structured_load(lists[which], (40 * i.4) + 2))), structured_load(lists[which], (40 * i.4) + 3) != 0u, load_lists(which, (40 * i.4) + 4), transpose(float2x3(asfloat(uint3(structured_load(lists[which], (40 * i.4) + 24), structured_load(lists[which], (40 * i.4) + 25), structured_load(lists[which], (40 * i.4) + 26))), asfloat(uint3(structured_load(lists[which], (40 * i.4) + 27), structured_load(lists[which], (40 * i.4) + 28), structured_load(lists[which], (40 * i.4) + 29))))), int2x3(convert<int3>(uint3(structured_load(lists[which], (40 * i.4) + 30), structured_load(lists[which], (40 * i.4) + 31), structured_load(lists[which], (40 * i.4) + 32))), convert<int3>(uint3(structured_load(lists[which], (40 * i.4) + 33), structured_load(lists[which], (40 * i.4) + 34), structured_load(lists[which], (40 * i.4) + 35)))), float3x1(asfloat(uint3(structured_load(lists[which], (40 * i.4) + 36), structured_load(lists[which], (40 * i.4) + 37), structured_load(lists[which], (40 * i.4) + 38)))), convert<half>(asfloat(structured_load(lists[which], (40 * i.4) + 39)))}
// CHECK-NEXT: }
// CHECK-NEXT: helper float3 normals_at(int i.6) {
// CHECK-NEXT:   return asfloat(uint3(structured_load(normals, 3 * i.6), structured_load(normals, (3 * i.6) + 1), structured_load(normals, (3 * i.6) + 2)))
// CHECK-NEXT: }
