// The position of a pixel: Direct3D's w is 1 / gl_FragCoord.w, and its origin is the upper left corner (Direct3D 11.3
// functional specification, 16.4; KHR_vulkan_glsl).
// RUN: %clipc -T ps_5_0 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=vulkan --validate --verify %s -o - | FileCheck %s --check-prefix=UPPER
// RUN: %clipc -T ps_5_0 --target=essl310 --flip-y --validate --verify %s -o - | FileCheck %s --check-prefix=UPPER
// RUN: %clipc -T ps_5_0 --target=essl310 -DWITHOUT_Y --validate %s -o - | FileCheck %s --check-prefix=X
float4 main(float4 position : SV_Position) : SV_Target {
#ifdef WITHOUT_Y
  return position.x;
#else
  return float4(position.xy, ddy(position.y), position.z / position.w);
#endif
}
// CHECK: layout(origin_upper_left) in vec4 gl_FragCoord;
// CHECK: SV_Target0 = vec4(gl_FragCoord.xy, -dFdy(gl_FragCoord.y), gl_FragCoord.z / (1.0 / gl_FragCoord.w));
// UPPER-NOT: origin_upper_left
// UPPER: SV_Target0 = vec4(gl_FragCoord.xy, dFdy(gl_FragCoord.y), gl_FragCoord.z / (1.0 / gl_FragCoord.w));
// X: SV_Target0
