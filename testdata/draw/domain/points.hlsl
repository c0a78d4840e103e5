// Domain shaders run for the points that Mesa's tessellator makes, and each value is held against the evaluator. Clip
// distances of control points are not drawn: Mesa 22.3.6 has those of number 0 for all.
// RUN: %draw compare %s -T ds_5_0 -E tri
// RUN: %draw compare %s -T ds_5_0 -E quad
// RUN: %draw compare %s -T ds_5_0 -E isoline
struct Point { float4 p : SV_Position; float3 normal : NORMAL; nointerpolation int kind : KIND; float2 uv[2] : TEXCOORD; };
struct Constants { float edges[3] : SV_TessFactor; float inside : SV_InsideTessFactor; float4 color : COLOR; uint number : NUMBER; };
struct Vertex { float4 p : SV_Position; float3 normal : NORMAL; float4 color : COLOR; nointerpolation int kind : KIND; };
cbuffer Frame { float4x4 view; float4 plane; float height; };

[domain("tri")] [clipplanes(plane)]
Vertex tri(Constants c, float3 at : SV_DomainLocation, uint id : SV_PrimitiveID, const OutputPatch<Point, 3> patch) {
  Vertex v;
  v.p = mul(view, patch[0].p * at.x + patch[1].p * at.y + patch[2].p * at.z);
  v.normal = patch[id % 3].normal * at.y;
  v.color = c.color * c.edges[1] + float4(patch[2].uv[1], c.inside, height);
  v.kind = patch[1].kind + int(id) + int(c.number);
  return v;
}

float3 Blend(OutputPatch<Point, 4> patch, float2 at) {
  return lerp(lerp(patch[0].normal, patch[1].normal, at.x), lerp(patch[2].normal, patch[3].normal, at.x), at.y);
}

[domain("quad")]
Vertex quad(const OutputPatch<Point, 4> patch, float2 at : SV_DomainLocation, float edges[4] : SV_TessFactor, float inside[2] : SV_InsideTessFactor) {
  Vertex v;
  v.p = float4(Blend(patch, at), 1) + patch[3].p;
  v.normal = float3(at, edges[3]);
  v.color = float4(edges[0], inside[0], inside[1], edges[2]);
  v.kind = 0;
  for (int i = 0; i < 4; ++i) v.kind += patch[i].kind;
  return v;
}

[domain("isoline")]
float4 isoline(const OutputPatch<Point, 2> patch, float2 at : SV_DomainLocation, float factors[2] : SV_TessFactor, out float4 rest : REST) : SV_Position {
  rest = float4(factors[0], factors[1], at);
  return lerp(patch[0].p, patch[1].p, at.x);
}
