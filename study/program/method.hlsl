// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// One shader, written each way that the study compares. PLANES is 0 to 6.
cbuffer Draw {
  float4x4 world_view_projection;
  float4x4 world;
  float4 planes[6];
};

struct Output {
#if defined BY_HAND
  float4 first : SV_ClipDistance0;  // what is left over is 0 and clips nothing
#if PLANES > 4
  float2 second : SV_ClipDistance1;
#endif
#endif
#if defined RECOMPUTED
  float3 place : PLACE;
#endif
  float3 normal : NORMAL;
  float4 position : SV_Position;
};

#if defined BY_HAND || defined RECOMPUTED || PLANES == 0
#elif PLANES == 1
[clipplanes(planes[0])]
#elif PLANES == 2
[clipplanes(planes[0], planes[1])]
#elif PLANES == 3
[clipplanes(planes[0], planes[1], planes[2])]
#elif PLANES == 4
[clipplanes(planes[0], planes[1], planes[2], planes[3])]
#elif PLANES == 5
[clipplanes(planes[0], planes[1], planes[2], planes[3], planes[4])]
#else
[clipplanes(planes[0], planes[1], planes[2], planes[3], planes[4], planes[5])]
#endif
Output main(float4 vertex : POSITION, float3 normal : NORMAL) {
  Output output;
  output.position = mul(vertex, world_view_projection);
  output.normal = mul(normal, (float3x3)world);
#if defined BY_HAND
  // As others write it: the distances of the world-space vertex.
  const float4 placed = mul(vertex, world);
  output.first = 0;
  output.first.x = dot(placed, planes[0]);
#if PLANES > 1
  output.first.y = dot(placed, planes[1]);
#endif
#if PLANES > 2
  output.first.z = dot(placed, planes[2]);
#endif
#if PLANES > 3
  output.first.w = dot(placed, planes[3]);
#endif
#if PLANES > 4
  output.second = 0;
  output.second.x = dot(placed, planes[4]);
#endif
#if PLANES > 5
  output.second.y = dot(placed, planes[5]);
#endif
#endif
#if defined RECOMPUTED
  output.place = mul(vertex, world).xyz;
#endif
  return output;
}
