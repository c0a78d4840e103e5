// Instances that only class linkage, or an assignment, tells.
// RUN: not %clipc -T vs_5_0 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
interface Light { float3 Shade(float3 n); };
class Sun : Light { float3 color; float3 Shade(float3 n) { return color; } };
Light light;
Sun sun;
float4 main(float3 n : NORMAL) : SV_Position {
  Light other;
  other = sun;
// CHECK: fail_interfaces.hlsl:[[#@LINE+6]]:23: error: a method of the interface `Light` is called on an object whose class is not known; only Direct3D's class linkage, for which GLSL has nothing, chooses it while the shader runs [interface-unknown]
// CHECK-NEXT:    [[#@LINE+5]] |   return float4(light.Shade(n) + other.Shade(n), 1);
// CHECK-NEXT:       |                       ^~~~~
// CHECK-NEXT: fail_interfaces.hlsl:[[#@LINE+3]]:40: error: a method of the interface `Light` is called on an object whose class is not known; only Direct3D's class linkage, for which GLSL has nothing, chooses it while the shader runs [interface-unknown]
// CHECK-NEXT:    [[#@LINE+2]] |   return float4(light.Shade(n) + other.Shade(n), 1);
// CHECK-NEXT:       |                                        ^~~~~
  return float4(light.Shade(n) + other.Shade(n), 1);
}
