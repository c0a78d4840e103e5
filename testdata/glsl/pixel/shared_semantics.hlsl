// Inputs of one semantic and type are one input up to 5.1, as are the elements of an array of structs. Oracle: vkd3d's
// entry-point-semantics.shader_test, checked against fxc; dxc refuses them.
// RUN: %clipc -T ps_5_0 -E main %s -o - 2>&1 | FileCheck --implicit-check-not=warning %s
// RUN: %draw compare %s -T ps_5_0 -E main
struct Pair {
  float4 first : TEXCOORD0;
  float2 second : TEXCOORD1;
};

// CHECK: layout(location = 0) in vec4 vs_TEXCOORD0;
// CHECK-NEXT: layout(location = 1) in vec2 vs_TEXCOORD1;
// CHECK-NOT: in vec
float4 main(Pair pairs[2], float4 again : texcoord0) : SV_Target {
  // CHECK-DAG: pairs[0].first = vs_TEXCOORD0;
  // CHECK-DAG: pairs[1].first = vs_TEXCOORD0;
  // CHECK-DAG: pairs[1].second = vs_TEXCOORD1;
  again.x = 7;
  return pairs[0].first + pairs[1].first * pairs[0].second.x + pairs[1].second.y * again;
}
