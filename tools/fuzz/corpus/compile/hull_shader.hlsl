//b0
struct Corner {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
};
struct Point {
  float3 position : POSITION;
  float3 normal : NORMAL;
};
struct Constants {
  float edges[3] : SV_TessFactor;
  float inside : SV_InsideTessFactor;
  float3 middle : MIDDLE;
};
cbuffer Frame {
  float level;
};

Constants OfPatch(InputPatch<Corner, 3> patch, const OutputPatch<Point, 3> points, uint id : SV_PrimitiveID) {
  Constants constants;
  for (int k = 0; k < 3; ++k) constants.edges[k] = level + patch[k].uv.x;
  constants.inside = level * id;
  constants.middle = (points[0].position + points[1].position + points[2].position) / 3;
  return constants;
}
[domain("tri")]
[partitioning("fractional_odd")]
[outputtopology("triangle_cw")]
[outputcontrolpoints(3)]
[patchconstantfunc("OfPatch")]
[maxtessfactor(20)]
Point main(InputPatch<Corner, 3> patch, uint i : SV_OutputControlPointID, uint id : SV_PrimitiveID) {
  Point p;
  p.position = patch[i].position.xyz;
  p.normal = patch[i].normal * id;
  return p;
}
