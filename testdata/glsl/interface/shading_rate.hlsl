// SV_ShadingRate (shader model 6.4) has Direct3D's numbers in Vulkan and in EXT_fragment_shading_rate too.
// RUN: %clipc -T vs_6_4 --target=vulkan --validate %s -o - | FileCheck %s --check-prefix=CHECK
// RUN: %clipc -T vs_6_4 --target=glsl450 --validate %s -o %t
// AUTOUPDATE
struct Output {
  float4 position : SV_Position;
  uint rate : SV_ShadingRate;
};
Output main(float4 p : POSITION, uint rate : RATE) {
  Output result = {p, rate};
  return result;
}

// CHECK: #version 460
// CHECK-NEXT: #extension GL_EXT_fragment_shading_rate : require
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in uint in_RATE0;  // rate : RATE0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint vs_SV_SHADINGRATE0;
// CHECK-NEXT:     gl_Position = in_POSITION0;
// CHECK-NEXT:     vs_SV_SHADINGRATE0 = in_RATE0;
// CHECK-NEXT:     gl_PrimitiveShadingRateEXT = int(vs_SV_SHADINGRATE0);
// CHECK-NEXT: }
