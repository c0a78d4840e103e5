// SV_ClipDistance without the attribute, gaps and all.
// RUN: %draw compare %s -T vs_5_0 -E main --lower clip-distance --target glsl450,glsl330,glsl130,essl300,vulkan

float4 planes[2];

struct Output {
  float4 position : SV_Position;
  float3 first : SV_ClipDistance0;
  float3 second : SV_ClipDistance1;
};

Output main(float4 position : POSITION) {
  Output result;
  result.position = position;
  result.first = float3(dot(position, planes[0]), position.x, position.y - 1);
  result.second = planes[1].xyz * position.w;
  return result;
}
