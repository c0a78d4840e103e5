// The binding of a counter that nothing changes is named, as it binds nothing.
// RUN: %clipc -T ps_5_1 --target=vulkan %s -o /dev/null 2>&1 | FileCheck %s --implicit-check-not=warning
RWStructuredBuffer<uint> counted : register(u1);
[[vk::counter_binding(7)]] RWStructuredBuffer<uint> changed : register(u2);
// CHECK: [[#@LINE+1]]:53: warning: `vk::counter_binding` of `untouched` has no effect: nothing changes its counter [-Wcounter-binding-unused]
[[vk::counter_binding(8)]] RWStructuredBuffer<uint> untouched : register(u3);
float4 main() : SV_Target { return changed.IncrementCounter() + untouched[1] + counted[0]; }
