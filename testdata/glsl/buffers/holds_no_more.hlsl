// What the shader does not need is not there: inputs, uniform blocks, resources, functions, constants, structs, distances, variables.
// RUN: %clipc -T vs_5_0 --validate -Wno-clip-distances-left-out %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --validate -Wno-clip-distances-left-out --target=vulkan %s -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %draw compare -T vs_5_0 %s
cbuffer Used { float4x4 view_projection; };
cbuffer Spare { float4 spare; };
Texture2D picture;
SamplerState point_sampler;
static const float kSpare = 3;
static float counter = 2;
struct Light {
  float4 color;
};
struct Vertex {
  float4 position : POSITION;
  float3 normal : NORMAL;
  uint instance : SV_InstanceID;
};
struct Output {
  float4 position : SV_Position;
  float2 distances : SV_ClipDistance;
};

float4 Never(float4 x) { return x * spare * kSpare; }
Light Lit(float3 normal) {
  Light light;
  light.color = float4(normal, 1);
  return light;
}

Output main(Vertex v, float2 uv : TEXCOORD) {
  Output o;
  float3 up = v.normal * 2;
  float4 lit = float4(up, counter);
  o.position = mul(v.position, view_projection);
  o.distances = float2(o.position.x, 1);
  return o;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Used {  // b0
// CHECK-NEXT:     mat4 view_projection;
// CHECK-NEXT: } used;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // position : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: // clip distances written: 0x1
// CHECK-NEXT: out float gl_ClipDistance[1];
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = used.view_projection * in_POSITION0;
// CHECK-NEXT:     vec2 distances = vec2(gl_Position.x, 1.0);
// CHECK-NEXT:     gl_ClipDistance[0] = distances.x;
// CHECK-NEXT: }

// VULKAN-NOT: Spare
// VULKAN-NOT: NORMAL
// VULKAN-NOT: picture
// VULKAN: void main() {
