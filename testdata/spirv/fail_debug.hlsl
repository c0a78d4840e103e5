// What -fspv-debug may be.
// RUN: not %clipc -T vs_6_0 -spirv -fspv-debug=all %s -o %t.spv 2>&1 | FileCheck %s
// CHECK: unknown value `all` of -fspv-debug
float4 main(float4 position : POSITION) : SV_Position { return position; }
