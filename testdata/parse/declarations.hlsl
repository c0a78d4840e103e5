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
ConstantBuffer<Inner> array_of[3] : register(sPaCe3);
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

// CHECK: cbuffer Scene register(b0)
// CHECK-NEXT:   member view : float4x4
// CHECK-NEXT:   member projection : float4x4
// CHECK-NEXT:   member bones[64] : float3x4 row_major
// CHECK-NEXT:   member plane : float4 packoffset(c20.x)
// CHECK-NEXT:   member offset : float2 packoffset(c21.z)
// CHECK-NEXT:   member inner : Inner
// CHECK-NEXT:     struct Inner
// CHECK-NEXT:       field a : float
// CHECK-NEXT:   member more[2] : Inner
// CHECK-NEXT: cbuffer <unnamed> register(b1, space2)
// CHECK-NEXT:   member unnamed : float
// CHECK-NEXT: tbuffer Table register(t3)
// CHECK-NEXT:   member rows[16] : float4
// CHECK-NEXT: cbuffer Shared
// CHECK-NEXT:   member s : float
// CHECK-NEXT: variable color : float4 uniform semantic COLOR = {1, 0, 0, 1}
// CHECK-NEXT: variable world : float4x4 semantic WORLD register(c4)
// CHECK-NEXT: variable profiles : float4 register(vs_5_0, c7) register(ps_5_0, c9[1])
// CHECK-NEXT: variable old : sampler2D register(s0)
// CHECK-NEXT: variable sizes[] : uint static const = {1, 2, 3}
// CHECK-NEXT: variable cache : float static
// CHECK-NEXT: variable group[16][2] : float4 groupshared
// CHECK-NEXT: variable v : float extern volatile
// CHECK-NEXT: variable u : uint
// CHECK-NEXT: variable w : uint
// CHECK-NEXT: variable d : uint
// CHECK-NEXT: variable dd : uint
// CHECK-NEXT: variable n : min16uint2
// CHECK-NEXT: variable h : min16float4
// CHECK-NEXT: variable v4 : vector<float, 4>
// CHECK-NEXT: variable m34 : matrix<float, 3, 4>
// CHECK-NEXT: variable v0 : vector
// CHECK-NEXT: variable m0 : matrix
// CHECK-NEXT: variable after : float4 const = 1
// CHECK-NEXT: variable textures[4] : Texture2D<float4> register(t0, space1)
// CHECK-NEXT: variable items : StructuredBuffer<Inner> register(t4)
// CHECK-NEXT: variable samples : Texture2DMS<float4, 4>
// CHECK-NEXT: variable image : RWTexture2D<float>
// CHECK-NEXT: variable constants : ConstantBuffer<Inner> register(b2)
// CHECK-NEXT: variable array_of[3] : ConstantBuffer<Inner> register(space3)
// CHECK-NEXT: variable bound : Texture2D
// CHECK-NEXT:   attribute layout((set = 0), (binding = 1))
// CHECK-NEXT: variable counted : RWStructuredBuffer<float>
// CHECK-NEXT:   attribute vk::binding(3, 1)
// CHECK-NEXT:   attribute vk::counter_binding(4)
// CHECK-NEXT: struct Vertex
// CHECK-NEXT:   field position : float4 semantic POSITION
// CHECK-NEXT:   field color : float4 nointerpolation semantic COLOR0
// CHECK-NEXT:   field uv[2] : float2 centroid noperspective semantic TEXCOORD3
// CHECK-NEXT:   field a : float
// CHECK-NEXT:   field b[2] : float
// CHECK-NEXT:   field c : float semantic FOG
// CHECK-NEXT:   field extra : float semantic EXTRA
// CHECK-NEXT:     attribute vk::location(2)
// CHECK-NEXT:   field low : uint bits 4
// CHECK-NEXT:   field high : uint bits 28
// CHECK-NEXT:   field <unnamed> : uint bits 4
// CHECK-NEXT: struct Empty
// CHECK-NEXT: struct Declared declared only
// CHECK-NEXT: variable anonymous : <unnamed>
// CHECK-NEXT:   struct <unnamed>
// CHECK-NEXT:     field x : float
// CHECK-NEXT: variable another : <unnamed>
// CHECK-NEXT:   struct <unnamed>
// CHECK-NEXT:     field x : float
// CHECK-NEXT: variable named[2] : Named
// CHECK-NEXT:   struct Named
// CHECK-NEXT:     field x : float
// CHECK-NEXT: variable constant : <unnamed> static const = {1}
// CHECK-NEXT:   struct <unnamed>
// CHECK-NEXT:     field x : float
// CHECK-NEXT: typedef Color : float4
// CHECK-NEXT: typedef Rows[3] : float4
// CHECK-NEXT: typedef Row : float4
// CHECK-NEXT: typedef Alias : Tagged
// CHECK-NEXT:   struct Tagged
// CHECK-NEXT:     field x : float
// CHECK-NEXT: typedef ConstFloat : float const
// CHECK-NEXT: typedef uint_type : uint
// CHECK-NEXT: variable elaborated : Vertex
