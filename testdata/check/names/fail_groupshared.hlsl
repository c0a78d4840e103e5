// Memory of a group of threads, in a stage that has none; a file may share its declaration with compute shaders.
// RUN: not %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s -DSTAGE=vertex
// RUN: not %clipc -T ps_6_0 -E pixel -fsyntax-only %s 2>&1 | FileCheck %s -DSTAGE=pixel
// RUN: %clipc -T vs_5_0 -E other -fsyntax-only %s 2>&1 | count 0
// CHECK: [[#@LINE+1]]:19: error: `memory` is `groupshared`, but [[STAGE]] shaders have no groups of threads that share memory; `static` makes a variable of its own for each run of the shader [group-shared]
groupshared float memory[4];
// CHECK-NOT: error
groupshared float3 unused;
float4 main(float4 p : POSITION) : SV_Position { memory[0] = p.x; return p * memory[0]; }
float4 pixel(float4 p : POSITION) : SV_Target { memory[0] = p.x; return p * memory[0]; }
float4 other(float4 p : POSITION) : SV_Position { return p; }
