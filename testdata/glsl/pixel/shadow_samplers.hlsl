// --shadow-samplers: Direct3D 9's textures of depth formats, which the driver compares with the third coordinate.
// RUN: %clipc -T ps_3_0 --shadow-samplers=map,maps --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_3_0 --shadow-samplers=map --shadow-samplers=maps --target=essl310 --flip-y --validate --verify %s -o - | FileCheck %s --check-prefixes=ES,CHECK
// RUN: %clipc -T ps_3_0 --shadow-samplers=map,maps --target=vulkan --validate --verify %s -o - | FileCheck %s --check-prefixes=VULKAN,CHECK
// RUN: %clipc -T ps_3_0 --shadow-samplers=map,maps --target=glsl120 --flip-y --validate --verify %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T ps_3_0 --shadow-samplers=map,maps -spirv %s -o %t.spv --reflect=%t.json
// RUN: FileCheck %s --check-prefix=JSON --input-file=%t.json
// RUN: %clipc -T ps_5_0 -E newer --shadow-samplers=either --validate --verify %s -o - | FileCheck %s --check-prefix=NEWER
// RUN: %clipc -T ps_3_0 --shadow-samplers=map,mpa,maps --verify %s -o - 2>&1 | FileCheck %s --check-prefix=UNKNOWN
// RUN: %clipc -T vs_3_0 -E vertex --shadow-samplers=map %s -o - 2>&1 | FileCheck %s --check-prefix=VERTEX
// RUN: %clipc -T vs_3_0 -E vertex --pixel-entry=main --shadow-samplers=map,maps %s -o %t.vert --pixel-output=%t.frag 2>&1 | count 0
// RUN: FileCheck %s --input-file=%t.frag
// RUN: %clipc -T vs_3_0 -E vertex --target=hlsl --shadow-samplers=map %s -o - 2>&1 | FileCheck %s --check-prefix=HLSL
texture depth;
sampler2D map = sampler_state { Texture = <depth>; MinFilter = Linear; };
sampler2D maps[2];
sampler plain;
float Shadow(sampler2D s, float4 p) { return tex2Dproj(s, p).x; }
float4 main(float4 p : TEXCOORD0, float2 uv : TEXCOORD1) : COLOR0 {
  float4 lit = tex2Dproj(map, p);
  lit += tex2Dlod(map, float4(uv, p.z, 1)) * tex2Dbias(map, p);
  lit.x += Shadow(maps[1], p) + Shadow(map, p.yxzw) + Shadow(plain, p);
  return lit * tex2Dlod(plain, float4(uv, p.z, 2)) + tex2Dbias(plain, p);
}
// ES: uniform highp sampler2DShadow map;
// ES: uniform highp sampler2DShadow maps[2];
// ES: uniform highp sampler2D plain;
// VULKAN: layout(set = 0, binding = 272) uniform sampler2DShadow map;
// VULKAN: uniform sampler2DShadow maps[2];
// VULKAN: uniform sampler2D plain;
// CHECK: return vec4(textureProj(maps[1], p)).x;
// CHECK: return vec4(textureProj(map, p)).x;
// CHECK: return textureProj(plain, p).x;
// CHECK: vec4 lit = vec4(textureProj(map, vs_TEXCOORD0));
// CHECK-NEXT: vec4(textureLod(map, vec3(vs_TEXCOORD1, vs_TEXCOORD0.z), 1.0)) * texture(map, vs_TEXCOORD0.xyz, vs_TEXCOORD0.w);
// CHECK: textureLod(plain, vec3(vs_TEXCOORD1, vs_TEXCOORD0.z).xy, 2.0) + texture(plain, vs_TEXCOORD0.xy, vs_TEXCOORD0.w);

// OLD: uniform sampler2DShadow map;
// OLD: vec4 lit = vec4(shadow2DProj(map, vs_TEXCOORD0).x);
// OLD-NEXT: vec4(shadow2DLod(map, vec3(vs_TEXCOORD1, vs_TEXCOORD0.z), 1.0).x) * shadow2D(map, vs_TEXCOORD0.xyz, vs_TEXCOORD0.w).x;
// JSON: "name": "map",
// JSON-NEXT: "type": "sampler2DShadow",
// JSON: "name": "maps",
// JSON-NEXT: "type": "sampler2DShadow[2]",
// JSON: "name": "plain",
// JSON-NEXT: "type": "sampler2D",

sampler either;
float4 newer(float4 p : TEXCOORD0) : SV_Target { return tex2Dproj(either, p); }
// NEWER: uniform sampler2DShadow either;
// NEWER: vec4(textureProj(either, vs_TEXCOORD0))

// UNKNOWN: warning: `--shadow-samplers` names `mpa`, but the shader reads no sampler of that name [-Wshadow-sampler-unknown]

float4 vertex(float4 p : POSITION, out float4 q : TEXCOORD0, out float2 uv : TEXCOORD1) : POSITION { q = p; uv = p.xy; return p; }
// VERTEX: warning: `--shadow-samplers` has no effect: this is not a pixel shader [-Woption-without-effect]
// HLSL: warning: `--shadow-samplers` has no effect: with --target=hlsl the text stays as it is [-Woption-without-effect]
