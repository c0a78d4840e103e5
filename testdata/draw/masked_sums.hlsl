// msad4 matches to the bit: GLSL gets a function for it.
// RUN: %draw compare %s -T vs_5_0 -E main --target glsl450,glsl330,essl300,vulkan --exact --lower none --ints -2000000000..2000000000
// RUN: %draw compare %s -T vs_5_0 -E main --target glsl450,essl310 --exact --lower none --ints 0..255 --seed 2

uint2 source;
uint4 sums;

struct Output {
  float4 position : SV_Position;
  uint4 all : A;
  uint4 masked : B;
};

Output main(float4 p : POSITION, uint4 q : BLENDINDICES) {
  Output result;
  result.position = p;
  result.all = msad4(q.x, source, sums);
  result.masked = msad4(q.y & 0xff00ff, q.zw, result.all);
  return result;
}
