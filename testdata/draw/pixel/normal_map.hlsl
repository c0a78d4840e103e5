// A normal map whose tangents are made of derivatives: with the wrong sign of ddy the bumps are dents. The tangents' handedness is drawn
// too. Oracle: the evaluator, whose y grows downwards as Direct3D's does (Direct3D 11.3 functional specification, 22.5.2, deriv_rty).
// RUN: %draw compare %s -T ps_5_0 --quarters
// RUN: %draw compare %s -T ps_5_0 --target glsl450,glsl330,essl300,essl310,vulkan --quarters --seed 3
// RUN: %clipc -T ps_5_0 %s -o - | FileCheck %s --check-prefix=GL
// RUN: %clipc -T ps_5_0 %s --target=vulkan -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %clipc -T ps_5_0 %s --flip-y -o - | FileCheck %s --check-prefix=VULKAN
Texture2D normals;
SamplerState linearly;
struct Colors {
  float4 bent : SV_Target0;
  float4 hand : SV_Target1;
};
Colors main(float3 place : PLACE, float2 uv : UV, float3 n : NORMAL) {
  // GL: vec3 py = -dFdy(vs_PLACE0);
  // VULKAN: vec3 py = dFdy(vs_PLACE0);
  const float3 px = ddx(place), py = ddy(place);
  const float2 ux = ddx(uv), uy = ddy(uv);
  const float3 tangent = px * uy.y - py * ux.y, bitangent = py * ux.x - px * uy.x;
  const float3 bump = normals.SampleLevel(linearly, uv, 0).xyz * 2 - 1;
  Colors c;
  c.bent = float4(tangent * bump.x + bitangent * bump.y + n * bump.z, 1);
  c.hand = float4(cross(px, py), ux.x * uy.y - ux.y * uy.x);
  return c;
}
