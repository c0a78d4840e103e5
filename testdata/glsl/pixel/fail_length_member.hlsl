// dxc has no Length. Oracle: vkd3d's length-property.shader_test, checked against dxc.
// RUN: not %clipc -T ps_6_0 %s -o - 2>&1 | FileCheck %s
Texture2D map;
// CHECK: error: `Texture2D<float4>` has no member `Length` [no-such-member, X3018]
float4 main() : SV_Target { return map.Length.xyxy; }
