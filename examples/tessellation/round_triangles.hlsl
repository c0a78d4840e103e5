// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Round triangles: a flat triangle bulges so that it follows the normals of its corners (Boubekeur and Alexa, "Phong Tessellation", 2008).
// clipc -T hs_5_0 -E Keep
// clipc -T ds_5_0 -E Bulge
struct Corner {
  float3 position : POSITION;
  float3 normal : NORMAL;
};

struct Cuts {
  float edges[3] : SV_TessFactor;
  float inside : SV_InsideTessFactor;
  float roundness : ROUNDNESS;  // of the whole patch: 0 is flat
};

struct Vertex {
  float4 position : SV_Position;
  float3 normal : NORMAL;
};

cbuffer Frame : register(b0) {
  float4x4 view_projection;
  float cuts;
};

Cuts Cut(InputPatch<Corner, 3> patch) {
  const float3 flat = normalize(cross(patch[1].position - patch[0].position, patch[2].position - patch[0].position));
  float bend = 0;
  for (int i = 0; i < 3; ++i) {
    bend = max(bend, 1 - abs(dot(flat, patch[i].normal)));
  }
  Cuts all;
  all.edges[0] = all.edges[1] = all.edges[2] = all.inside = cuts;
  all.roundness = 0.75 * saturate(4 * bend);
  return all;
}

[domain("tri")]
[partitioning("integer")]
[outputtopology("triangle_cw")]
[outputcontrolpoints(3)]
[patchconstantfunc("Cut")]
Corner Keep(InputPatch<Corner, 3> patch, uint number : SV_OutputControlPointID) {
  return patch[number];
}

// The point's nearest one in the plane of a corner.
float3 OnPlane(float3 position, Corner corner) {
  return position - dot(position - corner.position, corner.normal) * corner.normal;
}

[domain("tri")]
Vertex Bulge(Cuts all, float3 at : SV_DomainLocation, const OutputPatch<Corner, 3> patch) {
  const float3 flat = at.x * patch[0].position + at.y * patch[1].position + at.z * patch[2].position;
  const float3 bulged = at.x * OnPlane(flat, patch[0]) + at.y * OnPlane(flat, patch[1]) + at.z * OnPlane(flat, patch[2]);
  Vertex vertex;
  vertex.position = mul(float4(lerp(flat, bulged, all.roundness), 1), view_projection);
  vertex.normal = normalize(at.x * patch[0].normal + at.y * patch[1].normal + at.z * patch[2].normal);
  return vertex;
}
