// RUN: not %clipc -T vs_5_0 -E main %s 2>&1 | FileCheck %s
// CHECK: error: the value of `{{kA|kB}}` depends on itself [initialised-by-itself, X3004]
enum E { kA = E::kB, kB = E::kA };
float4 main(float4 v : POSITION) : SV_Position { return v * kB; }
