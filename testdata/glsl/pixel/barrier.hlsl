// The one barrier that Direct3D has outside of compute shaders: it orders stores, and waits for
// nothing. A function that only calls it still runs.
// RUN: %clipc %s -T ps_5_0 --validate -o - 2>&1 | FileCheck %s
// RUN: %clipc %s -T ps_6_0 --target=vulkan --validate -o - 2>&1 | FileCheck %s
globallycoherent RWTexture2D<float4> image : register(u1);

// CHECK: void order() {
// CHECK-NEXT: memoryBarrier();
void order() { DeviceMemoryBarrier(); }

// CHECK: void main() {
// CHECK: imageStore(
// CHECK-NEXT: memoryBarrier();
// CHECK: imageLoad(
// CHECK: i < 2; memoryBarrier(), i++
// CHECK: order();
float4 main(float4 p : SV_Position) : SV_Target {
  image[uint2(p.xy)] = p;
  DeviceMemoryBarrier();
  float4 sum = image[uint2(p.yx)];
  for (int i = 0; i < 2; DeviceMemoryBarrier(), i++) sum += image[uint2(p.xx) + i];
  order();
  return sum;
}
