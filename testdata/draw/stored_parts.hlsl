// Stores to parts of elements of structured buffers, aligned as std430 has them and tighter: the other parts keep their values.
// RUN: %draw compare %s -T vs_5_0 -E vs --target=glsl450,vulkan
// RUN: %draw compare %s -T vs_5_0 -E vs --target=essl310 --lower=none
struct Inner { float2 a; int b, c; };
struct Aligned { float4 color; Inner inner; float4 rows[2]; };
struct Tight { float3 color; bool seen; Inner inner; float last; };
RWStructuredBuffer<Aligned> aligned : register(u1);
RWStructuredBuffer<Tight> tight : register(u2);
RWStructuredBuffer<float4> vectors : register(u3);

void change(inout int x, out float2 y) { x += 2; y = x; }

float4 vs(float4 p : POSITION, uint i : SV_VertexID, out float4 sum : SUM, out float4 rest : REST) : SV_Position {
  aligned[i] = (Aligned)1;
  tight[i] = (Tight)2;
  vectors[i] = p;
  aligned[i].inner.a.y = p.x;
  aligned[i].rows[1].yz = p.xy;
  aligned[i].inner.b += 3;
  tight[i].seen = p.x > 0;
  tight[i].color.gb = p.yz;
  tight[i].last = aligned[i].inner.b;
  change(tight[i].inner.b, tight[i].inner.a);
  vectors[i].w = 1;
  vectors[i][0]++;
  vectors[i].xz = vectors[i].zx;
  sum = aligned[i].color + aligned[i].rows[0] + aligned[i].rows[1] * 3 + float4(aligned[i].inner.a, aligned[i].inner.b, aligned[i].inner.c);
  rest = float4(tight[i].color, tight[i].seen) + float4(tight[i].inner.a, tight[i].inner.b, tight[i].inner.c) * tight[i].last;
  return vectors[i];
}
