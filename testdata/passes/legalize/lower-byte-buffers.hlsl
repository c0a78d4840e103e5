// A byte address buffer is one of words: a function of the buffer loads or stores several, an atomic operation has a word's number.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-byte-buffers --stop-after=lower-byte-buffers %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target vulkan,glsl450 --lower none
// AUTOUPDATE
ByteAddressBuffer bytes : register(t0);
RWByteAddressBuffer written : register(u0);

float4 main(float4 p : POSITION, uint id : SV_VertexID) : SV_Position {
  uint size;
  bytes.GetDimensions(size);
  uint3 three = bytes.Load3(4);
  uint before;
  written.InterlockedAdd(16, 1, before);
  written.Store2(16 * id + 32, three.xy);
  return p + asfloat(three.z & 0x3F800000) + size;
}

// CHECK: program vs_5_0 form addressed
// CHECK-NEXT: resource StructuredBuffer<uint> bytes : t0 explicit
// CHECK-NEXT: resource RWStructuredBuffer<uint> written : u0 explicit
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: input uint in_SV_VERTEXID0 : SV_VertexID0 builtin vertex_id
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   uint id = in_SV_VERTEXID0
// CHECK-NEXT:   uint size
// CHECK-NEXT:   size = convert<uint>(buffer_size(bytes) * 4)
// CHECK-NEXT:   uint3 three = bytes_load3(4u)
// CHECK-NEXT:   uint before
// CHECK-NEXT:   before = atomic_add(written, 16u / 4u, value: 1u)
// CHECK-NEXT:   written_store2((16u * id) + 32u, three.xy)
// CHECK-NEXT:   vs_SV_POSITION0 = (in_POSITION0 + splat<float4>(asfloat(three.z & 1065353216u))) + splat<float4>(convert<float>(size))
// CHECK-NEXT: }
// CHECK-NEXT: helper uint3 bytes_load3(uint address) {
// CHECK-NEXT:   uint i = address / 4u
// CHECK-NEXT:   return uint3(structured_load(bytes, i), structured_load(bytes, i + 1u), structured_load(bytes, i + 2u))
// CHECK-NEXT: }
// CHECK-NEXT: helper void written_store2(uint address.1, uint2 value) {
// CHECK-NEXT:   store(written, address.1 / 4u, value: value.x)
// CHECK-NEXT:   store(written, (address.1 / 4u) + 1u, value: value.y)
// CHECK-NEXT: }
