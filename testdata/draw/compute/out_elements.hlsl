// What a function of HLSL's own or a method writes may be an element of a writable buffer or texture: an l-value as any other.
// RUN: %clipc %s -T cs_5_0 --validate -o %t.comp
// RUN: %draw compare %s -T cs_5_0
RWStructuredBuffer<uint> o;
RWStructuredBuffer<float> f;
RWTexture2D<uint> t;
StructuredBuffer<float4> source;
float4 p;
[numthreads(1, 1, 1)] void main() {
  InterlockedAdd(o[0], 1, o[1]);
  InterlockedCompareExchange(o[2], 5, 7, t[uint2(0, 1)]);
  sincos(p.x, f[0], f[1]);
  f[2] = modf(p.y, f[3]);
  source.GetDimensions(o[3], o[4]);
}
