// A buffer whose counter changes has a hidden one with the counter.
// RUN: %clipc -T ps_5_0 --verify --dump-after=make-counters --stop-after=make-counters %s | FileCheck %s
// AUTOUPDATE
RWStructuredBuffer<float4> seen : register(u1);
float4 main(float4 p : P) : SV_Target {
  seen[seen.IncrementCounter()] = p;
  return p;
}

// CHECK: program ps_5_0 form resolved
// CHECK-NEXT: resource RWStructuredBuffer<float4> seen : u1 explicit
// CHECK-NEXT: resource RWStructuredBuffer<uint> counter_var_seen : u0
// CHECK-NEXT: input float4 in_P0 : P0 location 0
// CHECK-NEXT: output float4 ps_SV_TARGET0 : SV_Target0 location 0
// CHECK-NEXT: entry float4 main(float4 p) {
// CHECK-NEXT:   store(seen, atomic_add(counter_var_seen, 0u, value: 1u), value: p)
// CHECK-NEXT:   return p
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float4 result = main(in_P0)
// CHECK-NEXT:   ps_SV_TARGET0 = result
// CHECK-NEXT: }
