// Vulkan has arrays of one dimension of textures, samplers and buffers (VUID-StandaloneSpirv-UniformConstant-04655), and so have GLSL
// before 4.30 and ES before 3.10: the dimensions become one, also where a function is given a part of such an array.
// RUN: %clipc -T ps_5_1 %s --target=vulkan --verify --validate --reflect=%t.json -o - | FileCheck %s
// RUN: FileCheck %s --check-prefix=JSON < %t.json
// RUN: %clipc -T ps_5_1 %s -spirv -o %t.spv
// RUN: %clipc -T ps_5_0 -E literal %s --target=glsl330 --validate -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T ps_5_0 -E literal %s --target=glsl450 --validate -o - | FileCheck %s --check-prefix=NEW
// RUN: %draw compare %s -T ps_5_0 -E literal --target=glsl330,essl300,glsl450,vulkan
// RUN: %draw compare %s -T ps_5_1 -E compared --target=vulkan,glsl450
// CHECK-DAG: uniform texture2D maps[6];  // t0
// CHECK-DAG: uniform texture2D cubic[8];  // t6
// CHECK-DAG: rgba32f) uniform image2D images[4];  // u1
// CHECK-DAG: uniform sampler taps[4];  // s0
// CHECK-DAG: } rows[4];
// JSON: "type": "Texture2D<float4>[6]",
// JSON-NEXT: "register": "t0",
Texture2D maps[2][3] : register(t0);
Texture2D cubic[2][2][2] : register(t6);
RWTexture2D<float4> images[2][2] : register(u1);
SamplerState taps[2][2];
StructuredBuffer<float4> rows[2][2] : register(t20);
uint k, n;
float4 row(Texture2D three[3], float2 uv) { return three[k].SampleLevel(taps[0][1], uv, 0); }
float4 all(Texture2D both[2][3], float2 uv) { return both[1][k].SampleLevel(taps[k][1], uv, 0) + both[n][k].SampleLevel(taps[1][0], uv, 0); }
float4 main(float2 uv : UV, nointerpolation uint i : I) : SV_Target {
  // CHECK: textureLod(sampler2D(maps[3], taps[3])
  float4 r = maps[1][0].SampleLevel(taps[1][1], uv, 0) + row(maps[k], uv) + all(maps, uv);
  // CHECK: texelFetch(cubic[4u + (globals.k * 2u + 1u)]
  // CHECK-SAME: texelFetch(cubic[globals.k * 4u + (2u + globals.n)]
  r += cubic[1][k][1].Load(int3(uv, 0)) + cubic[k][1][n].Load(int3(uv, 0));
  // CHECK: imageStore(images[2u + globals.k]
  images[1][k][uint2(0, 0)] = r;
  // CHECK: maps[nonuniformEXT(vs_I0 * 3u + 2u)]
  return r + rows[k][1][3] + maps[NonUniformResourceIndex(i)][2].SampleLevel(taps[0][0], uv, 0);
}

// OLD: uniform sampler2D maps[6];
// OLD: texture(maps[3], vs_UV0)
// NEW: uniform sampler2D maps[2][3];
// NEW: texture(maps[1][0], vs_UV0)
float4 literal(float2 uv : UV) : SV_Target { return maps[1][0].Sample(taps[0][1], uv) - maps[0][2].Sample(taps[0][1], uv); }

float4 compared(float2 uv : UV) : SV_Target {
  float4 r = row(maps[k & 1], uv);
  for (uint i = 0; i < 2; ++i) {
    for (uint j = 0; j < 2; ++j) r += cubic[i][j][(i + j) & 1].Load(int3(uv * 2, 0)) * (i * 2 + j);
  }
  return r;
}
