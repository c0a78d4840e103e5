// RUN: %clipc -T vs_5_0 %s -o - 2>&1 | FileCheck %s
// RUN: %clipc -T vs_5_0 %s -o - -Wno-attribute-unknown -Wno-attribute-without-effect 2>&1 | FileCheck %s --check-prefix=QUIET
// Each name is said once, wherever it stands.
// CHECK: unknown_attributes.hlsl:[[#@LINE+1]]:2: warning: unknown attribute `removeUnusedInputs` is ignored [-Wattribute-unknown]
[removeUnusedInputs] float4 unused(float4 v) { return v; }
[removeUnusedInputs] float4 again(float4 v) { return v; }
// CHECK: :[[#@LINE+1]]:3: warning: attribute `vk::ext_reference` has no effect; clipc does not translate it [-Wattribute-without-effect]
[[vk::ext_reference]] Texture2D<float4> t;
[[vk::ext_reference]] SamplerState s;
// CHECK: :[[#@LINE+2]]:3: warning: unknown attribute `ns::thing` is ignored
// CHECK: :[[#@LINE+1]]:14: warning: unknown attribute `other` is ignored
[[ns::thing, other(1)]] struct S { float4 a; };
// What tells a Direct3D 12 application how to bind is not said.
// CHECK-NOT: RootSignature
[RootSignature("CBV(b0)")]
[shader("vertex")]
float4 main(float4 v : POSITION) : SV_Position {
  // CHECK: :[[#@LINE+1]]:4: warning: unknown attribute `unrol` is ignored
  [unrol] [loop] for (int i = 0; i < 2; i++) v += i;
  [Unroll(2)] for (int j = 0; j < 2; j++) v += j;
  [fastopt] for (int k = 0; k < 2; k++) v += k;
  // CHECK-NOT: warning:
  [branch] if (v.x > 0) v = 1;
  return v;
}
[numthreads(8, 8, 1)] void compute() {}
// QUIET-NOT: warning:
