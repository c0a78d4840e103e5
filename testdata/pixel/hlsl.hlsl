// The pixel shader of the same file: outputs match inputs by semantic, take their places, and what
// nobody reads is left out with what only it needs.
// RUN: %clipc -E vs --pixel-shader=%s --pixel-entry=ps --validate --reflect=%t.json %s -o %t.vert
// RUN: FileCheck %s --input-file=%t.vert
// RUN: FileCheck %s --input-file=%t.json --check-prefix=JSON
// RUN: %clipc -E vs --pixel-shader=%s --pixel-entry=ps --keep-outputs --validate %s -o - | FileCheck %s --check-prefix=KEEP
// RUN: %clipc -E vs --pixel-shader=%s --pixel-entry=ps --names=dxc --validate %s -o - | FileCheck %s --check-prefix=NAMED
cbuffer Frame : register(b1) {
  float4x4 view_projection;
  float4 tint;
};
cbuffer Model : register(b2) {
  float4x4 world;
};
struct Varyings {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
  nointerpolation uint material : MATERIAL;
  float3x3 tangents : TANGENT;
};

// CHECK-NOT:  NORMAL
// CHECK:      layout(std140, binding = 1) uniform Frame {
// CHECK-NEXT:     layout(row_major) mat4 view_projection;
// CHECK-NEXT:     vec4 tint;
// CHECK-NEXT: } frame;
// CHECK:      layout(std140, binding = 2) uniform Model {
// CHECK:      layout(location = 0) in vec3 in_POSITION0;
// CHECK-NEXT: layout(location = 2) in vec2 in_TEXCOORD0;
// CHECK:      layout(location = 0) out vec2 input_uv;
// CHECK-NEXT: layout(location = 1) out mat3 input_tangents;
// CHECK-NEXT: layout(location = 4) flat out uint input_material;
// CHECK:      frame.view_projection
// CHECK:      input_tangents[2] =
// CHECK-NOT:  NORMAL
//
// NAMED:      uniform type_Frame {
// NAMED:      layout(location = 0) out vec2 in_var_TEXCOORD0;
// NAMED-NEXT: layout(location = 1) out mat3 in_var_TANGENT;
//
// KEEP:       layout(location = 0) out vec2 input_uv;
// KEEP:       layout(location = 5) out vec3 vs_NORMAL0;
//
// JSON:       "semantic": "TANGENT",
// JSON-NEXT:  "index": 0,
// JSON:       "pixelInput": {
// JSON-NEXT:    "name": "input_tangents",
// JSON-NEXT:    "element": 0
// JSON:       "name": "Frame",
// JSON:       "sharedWithPixelShader": true
Varyings vs(float3 position : POSITION, float3 normal : NORMAL, float2 uv : TEXCOORD0) {
  Varyings result;
  result.position = mul(view_projection, mul(world, float4(position, 1)));
  result.normal = normalize(normal) * tint.rgb;
  result.uv = uv;
  result.material = 3;
  result.tangents = (float3x3)world;
  return result;
}

struct Inputs {
  float2 uv : TEXCOORD0;
  float3x3 tangents : TANGENT;
  nointerpolation uint material : MATERIAL;
  float3 normal : NORMAL;
};
Texture2D albedo;
Texture2D shadows;
SamplerState linear_sampler;
SamplerComparisonState compare;
float4 ps(Inputs input, float4 position : SV_Position, bool is_front : SV_IsFrontFace) : SV_Target {
  float4 color = albedo.Sample(linear_sampler, input.uv) * tint;
  clip(color.a - 0.5);
  if (fwidth(color.r) > 1) discard;
  color *= shadows.SampleCmp(compare, input.uv, 0.5) + albedo.CalculateLevelOfDetail(linear_sampler, input.uv);
  if (is_front) color *= ddy_fine(input.uv).xyxy;
  return color + mul(input.tangents, float3(1, 0, input.material)).xyzz + ddx(position.x);
}
