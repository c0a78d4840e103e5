// RUN: not %clipc -T ps_5_0 %s 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_5_0 %s -DSAMPLY 2>&1 | FileCheck %s --check-prefix=SAMPLY
// RUN: not %clipc -T ps_3_0 %s -DOLD 2>&1 | FileCheck %s --check-prefix=OLD
// RUN: not %clipc -T ps_6_0 %s -DOLD 2>&1 | FileCheck %s --check-prefixes=OLD,DXIL
// OLD: [[#@LINE+1]]:17: error: unexpected text after `b0`; a register is {{.*}} [bad-register, X3530]
float number  : register(banana);
// DXIL: [[#@LINE+1]]:17: error: unexpected text after `c1`; a register is {{.*}} [bad-register, X3530]
float letters : register(c1many);
#ifdef SAMPLY
// SAMPLY: [[#@LINE+1]]:27: error: unexpected `samply`; {{.*}} [bad-register, X3530]
SamplerState s : register(samply);
#endif
#ifdef OLD
float4 main() : SV_Target { return number + letters; }
#else
// CHECK-DAG: [[#@LINE+1]]:18: error: unexpected text after `b0`; {{.*}} [bad-register, X3530]
cbuffer Buffer : register(b0many) { float a; };
// CHECK-DAG: [[#@LINE+1]]:18: error: unexpected text after `b0`; {{.*}} [bad-register, X3530]
SamplerState s : register(banana);
Texture2D t;
float4 main() : SV_Target { return t.Sample(s, a); }
#endif
