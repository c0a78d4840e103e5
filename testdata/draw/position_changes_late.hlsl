// The distances are those of the position that the shader returns, on every path, through an out parameter too.
// RUN: %draw compare %s -T vs_5_0 -E main

float4 planes[2];
float limit;

struct Output {
  float4 color : COLOR;
  float4 position : SV_Position;
};

[clipplanes(planes[0], planes[1])]
void main(float4 position : POSITION, float4 color : COLOR, out Output result) {
  result.position = position;
  result.color = color;
  if (position.x < limit) {
    result.position.zw = color.xy;
    return;
  }
  result.position += color;
  result.color *= 2;
}
