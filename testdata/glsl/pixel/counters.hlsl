// Counters of structured buffers are hidden buffers, as dxc's -spirv has them ("Counter variable" in its docs/SPIR-V.rst): a value
// before an increment, and after a decrement. The element of an append is where the counter was.
// RUN: %clipc %s -T ps_5_0 -E ps -DLISTS --target=vulkan --validate -o - | FileCheck %s --check-prefixes=CHECK,VULKAN
// RUN: %clipc %s -T ps_5_0 -E ps --target=glsl450 --validate -o - | FileCheck %s
// RUN: %clipc %s -T ps_5_0 -E ps --target=essl310 --validate -o - | FileCheck %s
// RUN: %clipc %s -T ps_5_0 -E ps --target=glsl450 --reflect=- -o %t.frag | FileCheck %s --check-prefix=REFLECT
struct Point {
  float4 place;
  uint id;
};
AppendStructuredBuffer<Point> added : register(u1);
[[vk::binding(2, 1), vk::counter_binding(7)]] ConsumeStructuredBuffer<float4> taken : register(u2);
RWStructuredBuffer<uint> counted : register(u3);
// VULKAN-DAG: } lists[2];
// VULKAN-DAG: } counter_var_lists[2];
// VULKAN-DAG: layout(std430, set = 1, binding = 7) buffer counter_var_taken_block {  // the counter of taken
// CHECK-DAG: buffer counter_var_added_block {  // the counter of added
// CHECK-DAG: uint counter_var_added[];
// CHECK-DAG: buffer counter_var_counted_block {  // the counter of counted
#ifdef LISTS
AppendStructuredBuffer<float3> lists[2] : register(u4);
#endif

// CHECK: return atomicAdd(counter_var_counted[0], 1u);
uint Number(RWStructuredBuffer<uint> of) { return of.IncrementCounter(); }

// REFLECT: "glsl": "counter_var_added"
// REFLECT: "counterOf": "added"
// CHECK: void main() {
float4 ps(float4 color : COLOR, nointerpolation uint id : ID) : SV_Target {
  Point made;
  made.place = color;
  made.id = id;
  // CHECK: added_store_at(int(atomicAdd(counter_var_added[0], 1u)), made);
  added.Append(made);
  // CHECK: uint n = Number();
  uint n = Number(counted);
  counted[n] = id;
#ifdef LISTS
  // VULKAN: uint temporary = which++;
  // VULKAN: lists_store_at(int(temporary), int(atomicAdd(counter_var_lists[temporary].elements[0], 1u)), vs_COLOR0.xyz);
  uint which = 0;
  lists[which++].Append(color.xyz);
#endif
  // CHECK: taken[atomicAdd(counter_var_taken[0], 4294967295u) - 1u]
  return taken.Consume() * n;
}

// A pixel whose discard waits changes no counter.
// RUN: %clipc %s -T ps_5_0 -E kept --target=glsl450 --validate -o - | FileCheck %s --check-prefix=KEPT
// RUN: %draw compare %s -T ps_5_0 -E kept --target=glsl450
Texture2D picture;
SamplerState smooth;
float4 kept(float4 color : COLOR, float2 uv : UV) : SV_Target {
  clip(color.x);
  // KEPT: if (!is_discarded) {
  // KEPT-NEXT: added_store_at(int(atomicAdd(counter_var_added[0], 1u)), made);
  Point made = (Point)0;
  added.Append(made);
  // KEPT: (is_discarded ? 1u : atomicAdd(counter_var_taken[0], 4294967295u)) - 1u
  const float4 last = taken.Consume();
  return picture.Sample(smooth, uv) + (last.x == last.x);
}
