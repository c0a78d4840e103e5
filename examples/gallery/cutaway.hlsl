// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Clip distances by hand: a box that is cut open, and objects that are culled as a whole.
// clipc -T vs_5_0
cbuffer Box {
  float4x4 view_projection;
  float3 low;
  bool enabled;
  float3 high;
  float fade_radius;
};

struct Varyings {
  float4 position : SV_Position;
  float3 below : SV_ClipDistance0;
  float3 above : SV_ClipDistance1;
  float culled : SV_CullDistance;
};

Varyings main(float3 position : POSITION) {
  Varyings o;
  o.position = mul(float4(position, 1), view_projection);
  o.below = enabled ? position - low : 1;
  o.above = enabled ? high - position : 1;
  o.culled = fade_radius - length(position);
  return o;
}
