// Values of any type in byte address buffers, as HLSL 2018 loads and stores them: their scalars,
// vectors and columns of matrices follow each other without padding (DXC's
// buffer-agg-load-stores.hlsl and RawBufferMethods.cpp).
// RUN: %draw compare %s -T vs_6_2 -E loads --target vulkan,glsl450,essl320 --lower none --ints 0..50
// RUN: %draw compare %s -T vs_6_2 -E stores --target vulkan,glsl450 --lower none
// RUN: %clipc -T vs_6_2 -E loads %s -o - | FileCheck %s --check-prefix=LOADS
// RUN: %clipc -T vs_6_2 -E stores %s -o - | FileCheck %s --check-prefix=STORES
// RUN: %clipc -T vs_6_2 -HV 2017 -E before %s -o - | FileCheck %s --check-prefix=BEFORE
// RUN: %clipc -T vs_5_0 -E before %s -o - | FileCheck %s --check-prefix=BEFORE
// RUN: %clipc -T vs_6_0 -E before %s -o - | FileCheck %s --check-prefix=BITS
struct Inner {
  int2 i;
  bool b;
};
struct Vertex {
  float3 position;
  float2x3 turn;
  half weights[2];
  Inner inner[2];
};
typedef float3 Places[3];
ByteAddressBuffer bytes;
RWByteAddressBuffer written;

// LOADS: uint temporary = {{.*}} * 68u;
// LOADS-NEXT: Vertex v = Vertex(uintBitsToFloat(bytes_load3(temporary)), transpose(mat3x2(uintBitsToFloat(bytes_load2(temporary + 12u)),
// LOADS-SAME: bytes_load(temporary + 64u)
float4 loads(uint id : SV_VertexID, uint n : N) : SV_Position {
  const Vertex v = bytes.Load<Vertex>(n * sizeof(Vertex));
  const Places places = bytes.Load<Places>(36);
  // The address has an effect, once.
  // LOADS: = n++ * 4u
  const float4x2 m = bytes.Load<float4x2>(n++ * 4);
  float sum = 0;
  // What is not a number of the input's range may be a NaN: only its bits are compared.
  sum += (asuint(v.position.z) & 0xff) + (asuint(v.turn[1][0]) & 0xff) + (asuint(v.turn[0].y) & 0xff);
  sum += (asuint(v.weights[1]) & 0xff) + (v.inner[1].i.y & 0xff) + v.inner[0].b;
  sum += (asuint(places[1].y) & 0xff) + (asuint(m[3].x) & 0xff) + (asuint(m[0].y) & 0xff);
  return float4(sum, bytes.Load<bool>(4 * id), bytes.Load<min16int>(8) & 0xff, n);
}

// STORES: written_store3(start, floatBitsToUint(v.position));
// STORES: written_store2(start + 12u, floatBitsToUint(vec2(v.turn[0][0], v.turn[1][0])));
// STORES: written_store(start + 64u, uint(v.inner[1].b));
struct Output {
  float4 position : SV_Position;
  float4 a : A;
  nointerpolation uint4 b : B;
};
Output stores(uint id : SV_VertexID, float4 p : P, float3 q : Q, int2 i : I) {
  Vertex v;
  v.position = q;
  v.turn = float2x3(p.xyz, q);
  v.weights[0] = p.x;
  v.weights[1] = p.y;
  v.inner[0].i = i;
  v.inner[0].b = i.x > 0;
  v.inner[1].i = i.yx;
  v.inner[1].b = i.y > 0;
  const uint start = id * 128;
  written.Store(start, v);
  written.Store<float3>(start + 68, q);
  written.Store(start + 80, p.x);
  written.Store(start + 84, i.x > 1);
  written.Store(start + 88, -1);
  Output o;
  const Vertex w = written.Load<Vertex>(start);
  o.position = float4(w.position + w.turn[1], w.weights[1]);
  o.a = float4(w.turn[0], w.inner[1].i.x) + written.Load<float4>(start + 68);
  o.b = uint4(w.inner[0].b, w.inner[1].b, written.Load2(start + 84));
  return o;
}

// BEFORE: written_store(0u, 1u)
// BITS: written_store(0u, floatBitsToUint(1.5))
float4 before(float4 p : P) : SV_Position {
  written.Store(0, 1.5);
  return p;
}
