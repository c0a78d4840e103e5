// Direct3D counts the components of clip and cull distances: these 8 lie in three registers of a signature, with gaps, and in GLSL's
// arrays one after another. Oracle: vkd3d's clip-cull-distance.shader_test, checked against fxc and Direct3D.
// RUN: %clipc -T vs_5_0 -E vs %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 -E ps %s -o - | FileCheck --check-prefix=PIXEL %s
// RUN: %draw compare %s -T vs_5_0 -E vs --lower clip-distance --target glsl450,vulkan
struct Output {
  float4 position : SV_Position;
  float3 near_far : SV_ClipDistance0;
  float2 sides : SV_ClipDistance1;
  float1 cull : SV_CullDistance0;
  float2 culls : SV_CullDistance1;
};

// CHECK: float gl_ClipDistance[5];
// CHECK: float gl_CullDistance[3];
Output vs(float4 p : POSITION, float4 d : D) {
  Output output;
  output.position = p;
  // CHECK-DAG: gl_ClipDistance[0] = {{.*}};
  // CHECK-DAG: gl_ClipDistance[3] = {{.*}};
  // CHECK-DAG: gl_ClipDistance[4] = {{.*}};
  output.near_far = d.xyz;
  output.sides = d.wx;
  // CHECK-DAG: gl_CullDistance[0] = {{.*}};
  // CHECK-DAG: gl_CullDistance[2] = {{.*}};
  output.cull = d.x;
  output.culls = d.yz;
  return output;
}

// PIXEL: vec2 sides = vec2(gl_ClipDistance[3], gl_ClipDistance[4]);
// PIXEL: vec2 culls = vec2(gl_CullDistance[1], gl_CullDistance[2]);
float4 ps(Output input) : SV_Target { return float4(input.sides.y, input.culls.y, 0, 1); }
