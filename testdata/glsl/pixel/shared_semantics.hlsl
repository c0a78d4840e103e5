// Inputs of one semantic and type are one input up to 5.1, as are the elements of an array of structs. Oracle: vkd3d's
// entry-point-semantics.shader_test, checked against fxc; dxc refuses them.
// RUN: %clipc -T ps_5_0 -E main %s -o - 2>&1 | FileCheck --implicit-check-not=warning %s
// RUN: %draw compare %s -T ps_5_0 -E main
// RUN: %clipc -T ps_5_0 -E others %s -o /dev/null 2>&1 | FileCheck --check-prefix=OTHERS %s
// RUN: %clipc -T ps_6_0 -E two %s -o /dev/null 2>&1 | FileCheck --check-prefix=DXC %s
// RUN: %clipc -T ps_5_0 -E position %s -o - 2>&1 | FileCheck --check-prefix=POSITION --implicit-check-not=warning %s
// RUN: %clipc -T ps_5_0 -E positions %s -o /dev/null 2>&1 | FileCheck --check-prefix=POSITIONS %s
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

// OTHERS: warning: semantic `TEXCOORD0` is used twice among the inputs, with different types; each use gets its own location, fxc reports an error [-Wsemantic-shared]
float4 others(float4 first : TEXCOORD0, float2 second : TEXCOORD0) : SV_Target { return first + second.xyxy; }

// DXC: warning: semantic `TEXCOORD0` is used twice among the inputs; each use gets its own location, dxc reports an error [-Wsemantic-shared]
float4 two(float4 first : TEXCOORD0, float4 second : TEXCOORD0) : SV_Target { return first + second; }

// System values have no location; those of one type are one input too.
// POSITION: = vec4(gl_FragCoord.xyz, 1.0 / gl_FragCoord.w) + vec4(gl_FragCoord.xyz
float4 position(float4 p : SV_Position, float4 q : SV_POSITION, bool f : SV_IsFrontFace, bool g : SV_IsFrontFace) : SV_Target { return p + q; }
// POSITIONS: warning: semantic `SV_POSITION0` is used twice among the inputs, with different types; fxc reports an error [-Wsemantic-shared]
float4 positions(float4 p : SV_Position, float2 q : SV_Position) : SV_Target { return p + q.xyxy; }
