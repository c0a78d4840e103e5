// Source of the rule: INSTR.ONLYONEALLOCCONSUME in DXC's docs/DXIL.rst.
// RUN: not %clipc %s -T ps_5_0 -E ps --target=glsl450 -o - 2>&1 | FileCheck %s
RWStructuredBuffer<uint> counted : register(u3);
uint Up(RWStructuredBuffer<uint> of) { return of.IncrementCounter(); }
// CHECK: [[#@LINE+1]]:49: error: the counter of `counted` is both incremented and decremented; a shader does one of the two to each counter [counter-both-ways]
uint Down(RWStructuredBuffer<uint> of) { return of.DecrementCounter(); }
float4 ps() : SV_Target { return Up(counted) + Down(counted); }
