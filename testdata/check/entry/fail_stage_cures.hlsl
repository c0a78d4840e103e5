// System values that one other stage has alone, and the size of a group: the message names the profile.
// RUN: not %clipc -T vs_5_0 -E ds %s -fsyntax-only 2>&1 | FileCheck %s --check-prefix=DOMAIN
// RUN: not %clipc -T vs_5_0 -E ps %s -fsyntax-only 2>&1 | FileCheck %s --check-prefix=PIXEL
// RUN: not %clipc -T vs_5_0 -E number %s -fsyntax-only 2>&1 | FileCheck %s --check-prefix=NUMBER
// RUN: %clipc -T vs_5_0 -E fill %s -fsyntax-only 2>&1 | FileCheck %s --check-prefix=GROUP
// DOMAIN: error: `SV_DomainLocation` is not an input of a vertex shader; `-T ds_5_0` compiles a domain shader [semantic-not-for-stage, X4502]
float4 ds(float3 place : SV_DomainLocation) : SV_Position { return place.xyzz; }
// PIXEL: error: `SV_IsFrontFace` is not an input of a vertex shader; `-T ps_5_0` compiles a pixel shader [semantic-not-for-stage, X4502]
float4 ps(bool is_front : SV_IsFrontFace) : SV_Target { return is_front; }
// Several stages have it.
// NUMBER: error: `SV_PrimitiveID` is not an input of a vertex shader [semantic-not-for-stage, X4502]
float4 number(uint number : SV_PrimitiveID) : SV_Position { return number; }
RWBuffer<float> values : register(u0);
// GROUP: [[#@LINE+1]]:1: warning: attribute `numthreads` has no effect on a vertex shader; `-T cs_5_0` compiles a compute shader [-Wattribute-misplaced]
[numthreads(8, 1, 1)] void fill() { values[0] = 1; }
