// --shadow-samplers: reads without a third coordinate, samplers that cannot compare, and targets without such samplers.
// RUN: not %clipc -T ps_3_0 -E flat --shadow-samplers=map %s -o - 2>&1 | FileCheck %s --check-prefix=FLAT
// RUN: not %clipc -T ps_3_0 -E cube --shadow-samplers=sky %s -o - 2>&1 | FileCheck %s --check-prefix=CUBE
// RUN: not %clipc -T ps_5_0 -E texel --shadow-samplers=picture %s -o - 2>&1 | FileCheck %s --check-prefix=TEXEL
// RUN: not %clipc -T ps_5_0 -E both --shadow-samplers=either %s -o - 2>&1 | FileCheck %s --check-prefix=BOTH
// RUN: not %clipc -T ps_5_0 -E compared --shadow-samplers=compares %s -o - 2>&1 | FileCheck %s --check-prefix=COMPARED
// RUN: not %clipc -T ps_3_0 -E projected --target=essl100 --shadow-samplers=map %s -o - 2>&1 | FileCheck %s --check-prefix=ES
// RUN: not %clipc -T ps_3_0 -E projected --target=webgl1 --shadow-samplers=map %s -o - 2>&1 | FileCheck %s --check-prefix=WEB
// RUN: not %clipc -T ps_3_0 -E projected --shadow-samplers=map,, %s -o - 2>&1 | FileCheck %s --check-prefix=LIST
sampler2D map;
samplerCUBE sky;
float4 Read(sampler2D s, float2 uv) { return tex2D(s, uv); }
float4 flat(float2 uv : TEXCOORD0) : COLOR {
  float4 c = tex2D(map, uv) + tex2D(map, uv, uv, uv);
  return c + tex2Dgrad(map, uv, uv, uv) + Read(map, uv);
}
// FLAT-DAG: [[#@LINE-3]]:14: error: `map` compares, as `--shadow-samplers` says, and this read has no third coordinate to compare with; write `tex2Dproj(map, float4(uv, z, 1))` [shadow-sampler-place]
// FLAT-DAG: [[#@LINE-4]]:31: error: `map` compares
// FLAT-DAG: [[#@LINE-4]]:14: error: `map` compares
// FLAT-DAG: [[#@LINE-8]]:46: error: `map` compares

float4 cube(float3 d : TEXCOORD0) : COLOR { return texCUBE(sky, d); }
// CUBE: 11:13: error: `--shadow-samplers` names `sky`, a `samplerCUBE`; Direct3D 9 compares textures that a `sampler2D` reads [shadow-sampler-kind]

Texture2D picture;
sampler either;
SamplerComparisonState compares;
float4 texel(float2 uv : UV) : SV_Target { return picture.Sample(either, uv); }
// TEXEL: [[#@LINE-4]]:11: error: `--shadow-samplers` names `picture`, a `Texture2D`
float4 both(float4 p : P) : SV_Target { return picture.Sample(either, p.xy) + tex2Dproj(either, p); }
// BOTH: [[#@LINE-5]]:9: error: `--shadow-samplers` names `either`, with which a method reads a texture; only `tex2Dproj`, `tex2Dlod` and `tex2Dbias` compare, and a method takes a `SamplerComparisonState` [shadow-sampler-method]
float4 compared(float4 p : P) : SV_Target { return picture.SampleCmp(compares, p.xy, p.z); }
// COMPARED: [[#@LINE-6]]:24: error: `--shadow-samplers` names `compares`, with which a method reads a texture

float4 projected(float4 p : TEXCOORD0) : COLOR { return tex2Dproj(map, p); }
// ES: 10:11: error: `map` is a sampler that compares; target `essl100` has none [target-shadow-sampler]
// ES-NEXT: {{10 \|}}
// ES: note: target `essl300` can
// WEB: note: target `webgl2` can
// LIST: clipc: error: `--shadow-samplers=map,,`: it needs names with commas between them, as `a,b`
