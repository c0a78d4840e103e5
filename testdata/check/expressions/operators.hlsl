// Operands are brought to a common type: the smaller vector wins, scalars are splatted, kinds are promoted.
// RUN: %clipc -T vs_5_0 -E main --dump=ir -Wno-implicit-truncation %s | FileCheck %s
float4 main(float4 v : POSITION, uint u : SV_VertexID) : SV_Position {
  int i = u;
  bool b = i;
  half h = 1;
  // CHECK: float3 a = v.xyz + float3(1.0, 2.0, 3.0)
  float3 a = v + float3(1, 2, 3);
  // CHECK: uint c = convert<uint>(i) * u
  uint c = i * u;
  // CHECK: int d = convert<int>(b) + convert<int>(b)
  int d = b + b;
  // CHECK: bool3 e = (a < splat<float3>(convert<float>(i))) && splat<bool3>(b)
  bool3 e = a < i && b;
  // CHECK: bool f = (b == true) || (!convert<bool>(i))
  bool f = b == true || !i;
  // CHECK: int g = (i << u) >> 1
  int g = i << u >> 1;
  // CHECK: int j = (~convert<int>(b)) ^ i
  int j = ~b ^ i;
  // CHECK: float k = convert<float>(i % 3) + (v.x % 2.0)
  float k = i % 3 + v.x % 2;
  // CHECK: int l = -2147483648
  int l = -2147483648;
  // CHECK: i = convert<int>(convert<float>(i) + 1.5)
  i += 1.5;
  // CHECK: i <<= u
  i <<= u;
  // CHECK: h *= 2.0h
  h *= 2.0f;
  // CHECK: b = b || f
  b |= f;
  // CHECK: v += splat<float4>(1.0)
  v += 1;
  // CHECK: v.yx = -v.xy
  v.yx = -v.xy;
  // CHECK: v--
  v--;
  // CHECK: k = float3
  // CHECK: k += v.x
  k = float3(1, 2, 3).x, k += v;
  return v * k + a.xyzz + c + d + f + g + j + l + h + all(e);
}
