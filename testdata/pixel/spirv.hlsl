// Pixel shaders in SPIR-V, of a struct that is a part of the vertex shader's in another order.
// RUN: %validate -D -V -S frag -e ps %s -o %t.spv
// RUN: %clipc -E vs --target=vulkan --validate --pixel-shader=%t.spv --pixel-entry=ps %s -o - | FileCheck %s --check-prefixes=CHECK,VULKAN
// RUN: %clipc -E vs --validate --pixel-shader=%t.spv --pixel-entry=ps %s -o - | FileCheck %s --check-prefixes=CHECK,GL
// RUN: %clipc -E vs --target=glsl330 --validate --pixel-shader=%t.spv --pixel-entry=ps %s -o - | FileCheck %s --check-prefix=NAMES
// VULKAN:     layout(std140, set = 0, binding = 3) uniform Frame {
// GL:         layout(std140, binding = 3) uniform Frame {
// CHECK-NEXT:     layout(row_major) mat4 view_projection;
// CHECK-NEXT:     vec4 tint;
// CHECK-NEXT: } frame;
// CHECK:      layout(location = 0) flat out uint i_material;
// CHECK-NEXT: layout(location = 1) out vec2 i_uv;
// CHECK-NEXT: layout(location = 3) out mat3x4 i_bones;
// CHECK-NOT:  NORMAL
// NAMES:      flat out uint i_material;
// NAMES-NEXT: out vec2 i_uv;
cbuffer Frame : register(b3) {
  float4x4 view_projection;
  float4 tint;
};
struct Varyings {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
  float3x4 bones : BONES;
  uint material : MATERIAL;
};
Varyings vs(float3 position : POSITION, float3 normal : NORMAL) {
  Varyings result;
  result.position = mul(view_projection, float4(position, 1));
  result.normal = normal;
  result.uv = position.xy;
  result.material = 3;
  result.bones = (float3x4)view_projection;
  return result;
}
struct Inputs {
  uint material : MATERIAL;
  float2 uv : TEXCOORD0;
  float2 unread : TEXCOORD1;
  float3x4 bones : BONES;
};
float4 ps(Inputs i) : SV_Target { return tint * i.material + i.uv.xyxy + i.bones[2]; }
