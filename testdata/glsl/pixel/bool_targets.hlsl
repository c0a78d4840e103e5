// A render target of bool: from 4.0 to 5.1 `true` is all bits of it, and from 6.0 on 1. Oracle: vkd3d's
// arithmetic-float-uniform.shader_test, checked against fxc and dxc.
// RUN: %clipc -T ps_4_0 %s -o - | FileCheck --check-prefix=BITS %s
// RUN: %clipc -T ps_5_1 %s -o - | FileCheck --check-prefix=BITS %s
// RUN: %clipc -T ps_6_0 %s -o - | FileCheck --check-prefix=ONE %s
// RUN: %draw compare %s -T ps_5_0
// RUN: %draw compare %s -T ps_6_0
struct Targets {
  bool4 less : SV_Target0;
  bool same : SV_Target1;
};

Targets main(float4 a : A, float4 b : B) {
  Targets targets;
  // BITS: SV_Target0 = -uvec4({{.*}});
  // BITS: SV_Target1 = -uint({{.*}});
  // ONE: SV_Target0 = uvec4({{.*}});
  // ONE: SV_Target1 = uint({{.*}});
  targets.less = a < b;
  targets.same = a.x == b.x;
  return targets;
}
