// Buffers: typed elements, structs in HLSL's tight packing, bytes; and what lies after their end is open.
// RUN: %draw compare %s -T vs_5_0 -E typed --target vulkan,glsl450,glsl140,essl310,essl320 --lower none --ints 0..12
// RUN: %draw compare %s -T vs_5_0 -E structured --target vulkan,glsl450,essl310 --lower none --ints 0..7
// RUN: %draw compare %s -T vs_5_0 -E structured --target glsl430 --lower none --ints 0..300
// RUN: %draw compare %s -T vs_5_0 -E rows --target vulkan,glsl450,essl310 --lower none --ints 0..40
// RUN: %draw compare %s -T vs_5_0 -E bytes --target vulkan,glsl450,essl320 --lower none --ints 0..50
// RUN: %draw compare %s -T vs_5_0 -E doubles --target vulkan,glsl450 --lower none --ints 0..20
// RUN: %draw compare %s -T vs_5_0 -E writes --target glsl450,vulkan --lower none

struct Particle {
  float3 position;
  int kind;
};
struct Instance {
  float4x3 world;
  row_major float2x3 uv;
  bool visible;
  float2 weights[3];
  Particle parts[2];
  uint flags;
};
Buffer<float4> colors : register(t0);
Buffer<int2> pairs : register(t1);
Buffer<uint> ids : register(t2);
StructuredBuffer<Particle> particles : register(t3);
StructuredBuffer<Instance> instances : register(t4);
StructuredBuffer<float3> points : register(t5);
StructuredBuffer<float4x4> matrices : register(t6);
StructuredBuffer<uint> indices : register(t7);
ByteAddressBuffer memory : register(t8);
struct Wide {
  int a;
  double d;
  float2 f;
  double2 e;
};
StructuredBuffer<Wide> wide : register(t9);
RWTexture2D<uint4> results : register(u0);

struct Output {
  float4 position : SV_Position;
  float4 a : A;
  float4 b : B;
  int4 c : C;
};

Output typed(int4 p : POSITION) {
  Output result;
  uint size;
  colors.GetDimensions(size);
  result.position = colors[p.x];
  result.a = colors.Load(ids[p.y] + p.z) * p;
  result.b = float4(pairs[p.w], size, ids[size - 1 - p.x]);
  result.c = int4(pairs[p.z].yx, p.xy);
  return result;
}

Output structured(int4 p : POSITION, uint vertex : SV_VertexID) {
  Output result;
  uint count, stride;
  instances.GetDimensions(count, stride);
  Particle particle = particles[vertex];
  result.position = float4(particle.position, particle.kind);
  Instance instance = instances[p.x];
  result.a = float4(mul(p, instance.world), instance.visible ? 1 : 2);
  result.b = float4(mul(float2(p.yz), instance.uv), instance.weights[1].y + instance.weights[2].x);
  result.c = int4(instance.flags, instance.parts[1].kind * 10 + particles[p.w].kind, count, stride);
  return result;
}

Output rows(int4 p : POSITION) {
  Output result;
  result.position = mul(float4(points[p.x], 1), matrices[p.y]);
  result.a = matrices[p.z][1];
  result.b = float4(points[indices[p.w]], points[p.w].y);
  uint count, stride;
  points.GetDimensions(count, stride);
  result.c = int4(indices[p.x], indices[p.y], count, stride);
  return result;
}

Output bytes(uint4 p : POSITION) {
  Output result;
  uint size;
  memory.GetDimensions(size);
  result.position = asfloat(memory.Load4(p.x * 16));
  result.a = float4(asfloat(memory.Load3(p.y * 12)), memory.Load(4 * p.z));
  result.b = float4(asfloat(memory.Load2(p.w * 8 + 4)), asfloat(memory.Load(size - 4)), size);
  result.c = memory.Load4(p.w * 4);
  return result;
}

Output doubles(uint4 p : POSITION) {
  Output result = (Output)0;
  Wide one = wide[p.x];
  result.position = float4(one.a, (float)one.d, one.f);
  result.a.xy = (float2)(wide[p.y].e * wide[p.z].d);
  return result;
}

Output writes(uint4 p : POSITION) {
  results[p.xy] = p;
  return (Output)0;
}
