// Arrays of more than 16 KiB, 16384 bytes, which is all that OpenGL promises of a block: constants of the application and memory of a
// group are read up to their far ends, on OpenGL and on lavapipe. So is a table of the shader on OpenGL; lavapipe of Mesa 22.3.6 needs
// minutes to compile one.
// RUN: %draw compare %s -T vs_5_0 -E far --target=glsl330,glsl410,glsl450,essl300,vulkan --direct3d --random 16
// RUN: %draw compare %s -T vs_5_0 -E table --target=glsl330,glsl450,essl300 --direct3d --lower none --random 16
// RUN: %draw compare %s -T vs_5_0 -E matrices --target=glsl330,glsl450,vulkan --direct3d --random 16
// RUN: %draw compare %s -T cs_5_0 -E buffers --target=glsl430,glsl450,essl310,vulkan
cbuffer Large {
  float4 first;
  float4 many[2000];
  float3 last;
};

// 32032 bytes: row 1024 begins after 16384.
float4 far(uint n : N, out float4 at_end : A, out float3 after_end : B) : SV_Position {
  at_end = many[1999 - n % 4u];
  after_end = last + many[1023 + n % 3u].yzw;
  return many[(n * 613u) % 2000u] + first;
}

#define ROW(i) i, i + 1, i * 2, i ^ 5
#define ROWS(i) ROW(i), ROW(i + 4), ROW(i + 8), ROW(i + 12), ROW(i + 16), ROW(i + 20), ROW(i + 24), ROW(i + 28)
#define MORE(i) ROWS(i), ROWS(i + 32), ROWS(i + 64), ROWS(i + 96), ROWS(i + 128), ROWS(i + 160), ROWS(i + 192), ROWS(i + 224)
#define MOST(i) MORE(i), MORE(i + 256), MORE(i + 512), MORE(i + 768)
// 18432 bytes.
static const int kTable[4608] = {MOST(0), MOST(1024), MOST(2048), MOST(3072), MORE(4096), MORE(4352)};
float4 table(uint n : N, out int4 read : R) : SV_Position {
  read = int4(kTable[4607 - n % 9u], kTable[4095 + n % 3u], kTable[n % 4608u], kTable[0]);
  return first;
}

cbuffer Poses { float4x4 poses[300]; float3x4 rest[100]; };
// 19200 bytes, and then 4800.
float4 matrices(float4 p : P, uint n : N, out float4 second : S) : SV_Position {
  second = float4(mul(rest[99 - n % 2u], p), poses[299][3][3]);
  return mul(p, poses[299 - n % 3u]) + poses[256][0];
}

StructuredBuffer<float4> input;
RWStructuredBuffer<float4> output;
groupshared uint shared_words[4200];
// 16800 bytes that the threads of a group share.
[numthreads(32, 1, 1)]
void buffers(uint i : SV_GroupIndex, uint id : SV_DispatchThreadID) {
  for (uint k = 4096 + i; k < 4200; k += 32) shared_words[k] = k * k;
  GroupMemoryBarrierWithGroupSync();
  output[id] = float4(many[1999 - i].xy, shared_words[4199 - i], shared_words[4096 + i]) + input[id];
}
