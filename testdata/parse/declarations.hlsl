// RUN: %clipc --dump=ast %s | FileCheck %s
// AUTOUPDATE
cbuffer Scene : register(b0) {
  float4x4 view, projection;
  row_major float3x4 bones[64];
  float4 plane : packoffset(c20);
  float2 offset : packoffset(c21.z);
  struct Inner { float a; } inner;
  Inner more[2];
}
cbuffer : register(b1, space2) { float unnamed; };
tbuffer Table : register(t3) { float4 rows[16]; };
shared cbuffer Shared { float s; };

uniform float4 color : COLOR = {1, 0, 0, 1};
float4x4 world : WORLD : register(c4);
float4 profiles : register(vs_5_0, c7) : register(ps_5_0, c9[1]);
sampler2D old : register(s);
const static uint sizes[] = {1, 2, 3};
static float cache;
groupshared float4 group[16][2];
extern volatile float v;
unsigned int u;
unsigned w;
dword d;
DWORD dd;
unsigned min16int2 n;
min16float4 h;
vector<float, 4> v4;
matrix<float, 3, 4> m34;
vector v0;
matrix m0;
float4 const after = 1;
Texture2D<float4> textures[4] : register(t0, space1);
StructuredBuffer<Inner> items : register(t4);
Texture2DMS<unorm float4, 4> samples;
RWTexture2D<float> image;
ConstantBuffer<Inner> constants : register(b2);
ConstantBuffer<Inner> array_of[3] : register(space3);
layout(set = 0, binding = 1) Texture2D bound;
[[vk::binding(3, 1)]] [[vk::counter_binding(4)]] RWStructuredBuffer<float> counted;

struct Vertex {
  float4 position : POSITION;
  nointerpolation float4 color : COLOR0;
  noperspective centroid float2 uv[2] : TEXCOORD3;
  float a, b[2], c : FOG;
  [[vk::location(2)]] float extra : EXTRA;
  uint low : 4, high : 28;
  uint : 4;
};
struct Empty {};
struct Declared;
struct { float x; } anonymous, another;
struct Named { float x; } named[2];
static const struct { float x; } constant = {1};
typedef float4 Color;
typedef float4 Rows[3], Row;
typedef struct Tagged { float x; } Alias;
typedef const float ConstFloat;
typedef unsigned int uint_type;
struct Vertex elaborated;
;
