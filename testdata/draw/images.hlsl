// Images: what a vertex or a pixel stores and changes in one step, it reads back. Each has texels of its own. Oracle: the evaluator.
// RUN: %draw compare %s -T vs_5_0 -E vs --target=glsl450,vulkan
// RUN: %draw compare %s -T ps_5_0 -E ps --target=glsl450,glsl430,vulkan
// RUN: %draw compare %s -T ps_5_0 -E both --target=essl310,essl320,vulkan
// RUN: %draw compare %s -T ps_5_0 -E ways --target=essl310,essl320,glsl450
RWTexture1D<float2> line1 : register(u8);
RWTexture1DArray<int> lines : register(u1);
RWTexture2D<float4> picture : register(u2);
RWTexture2DArray<uint2> pages : register(u3);
RWTexture3D<float3> volume : register(u4);
RWBuffer<uint> counts : register(u5);
RWTexture2D<int> signs : register(u6);
RWTexture2D<float> plain : register(u7);

float4 Use(uint i, float4 p) {
  const uint2 at = uint2(i % 16, i / 16);
  uint old, other, width, height, elements;
  float4 sum = picture[at] + line1[i].xyxy + volume[uint3(at, i % 5)].xyzx + pages[uint3(at, 2)].yxyx % 7;
  line1[i].y = p.x;
  lines[uint2(i, 3)] = int(i) - 7;
  picture[at].xz = p.yw;
  picture[at] += 1;
  pages[uint3(at, 1)] = uint2(i, 3);
  volume[uint3(at, 4)] = p.zyx;
  counts[i] = i;
  InterlockedAdd(counts[i], 5, old);
  InterlockedCompareExchange(counts[i], i + 5, 9, other);
  InterlockedMax(signs[at], 4);
  InterlockedMin(signs[at], 900);
  pages.GetDimensions(width, height, elements);
  sum += float4(line1[i], lines[uint2(i, 3)], signs[at]) + picture[at] + pages[uint3(at, 1)].xyxy + volume[uint3(at, 4)].xyzz;
  return sum + old + other * 2 + counts[i] * 3 + width + height * 2 + elements * 3;
}

float4 vs(float4 p : POSITION, uint i : SV_VertexID, out float4 sum : SUM) : SV_Position { return sum = Use(i, p); }
float4 ps(float4 p : SV_Position, float4 value : VALUE) : SV_Target { return Use(uint(p.x) % 16 + uint(p.y) % 16 * 16, value); }

// What OpenGL ES may read and write: one component of 32 bits.
float4 both(float4 p : SV_Position, float4 value : VALUE) : SV_Target {
  const uint2 at = uint2(p.xy) % 16;
  uint old, width, height;
  int before;
  plain[at] += value.x;
  InterlockedAdd(signs[at], -3, before);
  InterlockedExchange(counts[at.x + 16 * at.y], 77, old);
  signs.GetDimensions(width, height);
  return float4(plain[at], before, signs[at], old) + counts[at.x + 16 * at.y] + width + height;
}
// And of other formats, those that it only reads or only writes.
float4 ways(float4 p : SV_Position, float4 value : VALUE) : SV_Target {
  const uint2 at = uint2(p.xy) % 16;
  volume[uint3(at, 2)] = value.xyz;
  return picture[at] * 2 + value;
}
