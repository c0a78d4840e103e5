// Targets without compute shaders name the nearest one that has them.
// RUN: not %clipc %s -T cs_5_0 --target=glsl420 2>&1 | FileCheck %s -DTARGET=glsl420 -DNEAR=glsl430
// RUN: not %clipc %s -T cs_5_0 --target=essl300 2>&1 | FileCheck %s -DTARGET=essl300 -DNEAR=essl310
// RUN: not %clipc %s -T cs_5_0 --target=webgl2 2>&1 | FileCheck %s -DTARGET=webgl2 -DNEAR=glsl430
RWTexture2D<float> image;
// CHECK-NOT: error
// CHECK: [[#@LINE+3]]:6: error: `main` is a compute shader; target `[[TARGET]]` has none [target-compute-shader]
// CHECK: note: target `[[NEAR]]` can
[numthreads(8, 8, 1)]
void main(uint2 place : SV_DispatchThreadID) { image[place] = 1; }
// CHECK-NOT: error
