// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Terrain: a square patch is cut finer where it is near, is lifted by a texture of heights, and ends at the plane of the water.
// clipc -T hs_5_0 -E Keep
// clipc -T ds_5_0 -E Lift
struct Corner {
  float3 position : POSITION;
};

struct Cuts {
  float edges[4] : SV_TessFactor;
  float inside[2] : SV_InsideTessFactor;
};

struct Vertex {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
};

cbuffer Frame : register(b0) {
  float4x4 view_projection;
  float4 water_plane;  // in clip space
  float3 eye;
  float height, cuts_at_one_unit;
};
Texture2D<float> heights : register(t0);
SamplerState clamped : register(s0);

// Two patches that share an edge cut it alike: the factor depends on the edge alone.
float CutsOf(float3 a, float3 b) {
  return clamp(cuts_at_one_unit * distance(a, b) / distance(eye, (a + b) / 2), 1, 64);
}

Cuts Cut(InputPatch<Corner, 4> patch) {
  Cuts cuts;
  cuts.edges[0] = CutsOf(patch[0].position, patch[2].position);
  cuts.edges[1] = CutsOf(patch[0].position, patch[1].position);
  cuts.edges[2] = CutsOf(patch[1].position, patch[3].position);
  cuts.edges[3] = CutsOf(patch[2].position, patch[3].position);
  cuts.inside[0] = (cuts.edges[1] + cuts.edges[3]) / 2;
  cuts.inside[1] = (cuts.edges[0] + cuts.edges[2]) / 2;
  return cuts;
}

[domain("quad")]
[partitioning("fractional_even")]
[outputtopology("triangle_cw")]
[outputcontrolpoints(4)]
[patchconstantfunc("Cut")]
[maxtessfactor(64)]
Corner Keep(InputPatch<Corner, 4> patch, uint number : SV_OutputControlPointID) {
  return patch[number];
}

float HeightAt(float2 uv) {
  return height * heights.SampleLevel(clamped, uv, 0);
}

[domain("quad")]
[clipplanes(water_plane)]
Vertex Lift(Cuts cuts, float2 uv : SV_DomainLocation, const OutputPatch<Corner, 4> patch) {
  const float STEP = 1.0 / 256;
  const float3 near = lerp(patch[0].position, patch[1].position, uv.x);
  const float3 far = lerp(patch[2].position, patch[3].position, uv.x);
  float3 position = lerp(near, far, uv.y);
  position.y += HeightAt(uv);
  const float2 slope = float2(HeightAt(uv + float2(STEP, 0)) - HeightAt(uv - float2(STEP, 0)),
                              HeightAt(uv + float2(0, STEP)) - HeightAt(uv - float2(0, STEP)));
  Vertex vertex;
  vertex.position = mul(float4(position, 1), view_projection);
  vertex.normal = normalize(float3(-slope.x, 2 * STEP, -slope.y));
  vertex.uv = uv;
  return vertex;
}
