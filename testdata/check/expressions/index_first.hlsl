// An index is evaluated before the vector that it picks from, where both have effects, up to 5.1; from 6.0 on after it. Oracle:
// vkd3d's side-effects.shader_test, checked against fxc and dxc.
// RUN: %clipc -T ps_5_0 %s -o - | FileCheck --check-prefix=FXC %s
// RUN: %clipc -T ps_6_0 %s -o - | FileCheck --check-prefix=DXC %s
// RUN: %draw compare %s -T ps_5_0
// RUN: %draw compare %s -T ps_6_0
static uint calls = 0;

float4 Next() {
  ++calls;
  return float4(0.25, 0.5, 0.75, 1) * calls;
}

float4 main() : SV_Target {
  // FXC: (temporary = uint(max(0.0, Next().w)), Next()[temporary])
  // DXC: Next()[uint(Next().w)]
  return Next()[(uint)Next().w];
}
