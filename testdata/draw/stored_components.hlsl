// Stores to components that a swizzle with gaps, a variable index or a row of a matrix chooses: the other components keep their values,
// and what chooses is evaluated once.
// RUN: %draw compare %s -T vs_5_0 -E vs --target=glsl450,vulkan
// RUN: %draw compare %s -T vs_5_0 -E vs --target=essl310 --lower=none
// RUN: %draw compare %s -T ps_5_0 -E ps --target=glsl430,essl310,vulkan
struct Aligned { float4 v; float4 list[3]; float4x4 m; int4 n; };
struct Tight { float3 color; int list[3]; float2 pairs[2]; };
RWStructuredBuffer<Aligned> aligned : register(u1);
RWStructuredBuffer<Tight> tight : register(u2);
RWStructuredBuffer<float4> vectors : register(u3);
RWStructuredBuffer<row_major float3x4> matrices : register(u4);

void change(inout float x, out float2 y, inout uint k) { x += 2; y = x; k = 2 - k; }

float4 Store(float4 p, uint i, uint k) {
  const int j = int(k) & 1;
  aligned[i] = (Aligned)1;
  tight[i] = (Tight)2;
  vectors[i] = p;
  matrices[i] = (float3x4)3;
  aligned[i].v.xz = p.yw;
  aligned[i].v.wy = p.xz;
  aligned[i].list[k].zyx = p.xyw;
  aligned[i].list[2 - k][j] = p.x;
  aligned[i].list[1].xw[j] += p.y;
  aligned[i].m[1] = p;
  aligned[i].m[2].yx = p.xy;
  aligned[i].m[j + 2][k] = p.z;
  aligned[i].m._m03_m12_m01 = p.xyz;
  aligned[i].m._m00_m33[j] = 7;
  aligned[i].n[k]++;
  tight[i].color[k] = p.x;
  tight[i].color.zx += p.yz;
  tight[i].list[k] = 5;
  tight[i].pairs[j].y = p.w;
  tight[i].pairs[1 - j] = p.xy;
  matrices[i][k].xw = p.xy;
  matrices[i]._m02_m21 *= 2;
  uint at = k;
  vectors[i][at] = at++;
  vectors[i][at & 3] += at++;
  float2 both = vectors[i].yx = p.zw;
  change(aligned[i].v[k], aligned[i].list[k].xz, k);
  float4 sum = vectors[i] + aligned[i].v + aligned[i].n + float4(both, at, k);
  for (int r = 0; r < 3; r++) sum += aligned[i].list[r] * (r + 1) + matrices[i][r] * (r + 2);
  for (int q = 0; q < 4; q++) sum = sum.yzwx + aligned[i].m[q];
  return sum + float4(tight[i].color, tight[i].list[0] + 3 * tight[i].list[1] + tight[i].list[2] * 9) +
         float4(tight[i].pairs[0], tight[i].pairs[1]);
}

float4 vs(float4 p : POSITION, uint i : SV_VertexID, out float4 sum : SUM) : SV_Position {
  sum = Store(p, i, i % 3);
  return p;
}

float4 ps(float4 p : SV_Position, float4 value : VALUE) : SV_Target {
  const uint i = uint(p.x) % 16 + uint(p.y) % 4 * 16;
  return Store(value, i, i % 3);
}
