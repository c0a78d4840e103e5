// RUN: not %clipc -T vs_6_4 --target=glsl330 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
// CHECK: fail_shading_rate.hlsl:[[#@LINE+3]]:50: error: the shader writes `SV_ShadingRate`; target `glsl330` has no such output [target-shading-rate]
// CHECK-NEXT:     [[#@LINE+2]] | float4 main(float4 p : POSITION, out uint rate : SV_ShadingRate) : SV_Position {
// CHECK-NEXT:       |                                                  ^~~~~~~~~~~~~~
float4 main(float4 p : POSITION, out uint rate : SV_ShadingRate) : SV_Position {
  rate = 0;
  return p;
}
