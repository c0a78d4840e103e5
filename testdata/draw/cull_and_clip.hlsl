// Clip and cull distances that share a vector, and outputs after them.
// RUN: %draw compare %s -T vs_5_0 --target vulkan,glsl450 --lower none

struct Output {
  float4 position : SV_Position;
  float one : ONE;
  float2 two : TWO;
  float2 three : THREE;
  float2 clip : SV_ClipDistance;
  float first : SV_CullDistance0;
  float2 second : SV_CullDistance1;
};

Output main(float4 position : POSITION) {
  Output result;
  result.position = position;
  result.one = position.x * 2;
  result.two = position.yz * 3;
  result.three = position.xw * 4;
  result.clip = position.xw - 1;
  result.first = position.x + 5;
  result.second = position.yz * 6;
  return result;
}
