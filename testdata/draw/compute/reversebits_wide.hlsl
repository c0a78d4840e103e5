// reversebits of 64 bits reverses all of them (DXC's test intrinsics.reversebits.hlsl), of a vector too.
// RUN: %draw compare %s -T cs_6_0 --target=glsl450
RWStructuredBuffer<uint> o;
cbuffer C { uint4 words; }
uint64_t Of(uint2 w) { return (uint64_t)w.x << 32 | w.y; }
[numthreads(1, 1, 1)] void main() {
  uint64_t r = reversebits(Of(words.xy));
  uint64_t2 both = reversebits(uint64_t2(Of(words.zw), Of(words.xw)));
  o[0] = (uint)(r >> 32);
  o[1] = (uint)r;
  o[2] = (uint)(both.x >> 32);
  o[3] = (uint)both.y;
}
