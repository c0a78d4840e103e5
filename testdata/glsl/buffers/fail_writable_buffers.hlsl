// Where a target cannot write, or would write elsewhere than Direct3D.
// RUN: not %clipc -T vs_5_0 -DOLD --target=glsl330 %s -o %t 2>&1 | FileCheck %s --check-prefix=OLD
// RUN: not %clipc -T vs_5_0 --target=glsl450 %s -o %t 2>&1 | FileCheck %s --check-prefix=CHECK
// AUTOUPDATE
#ifdef OLD
// OLD: fail_writable_buffers.hlsl:[[#@LINE+4]]:20: error: `numbers` is writable; clipc does not translate that for target `glsl330`, only for GLSL from 4.20 on, ES from 3.10 on and Vulkan [target-image]
// OLD-NEXT:     [[#@LINE+3]] | RWBuffer<uint4>    numbers;
// OLD-NEXT:       |                    ^~~~~~~
// OLD-NEXT: clipc: note: target `glsl420` can
RWBuffer<uint4>    numbers;
float4 main(float4 p : POSITION) : SV_Position {
  numbers[1] = 2;
  return p;
}
#else
RWStructuredBuffer<double3> tight;
float4 main(float4 p : POSITION) : SV_Position {
// CHECK: fail_writable_buffers.hlsl:[[#@LINE+3]]:3: error: a `double3` is written into a structured buffer; target `glsl450` lays it out differently from Direct3D [target-structured-store]
// CHECK-NEXT:    [[#@LINE+2]] |   tight[1] = p.xyz;
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~
  tight[1] = p.xyz;
  return p;
}
#endif
