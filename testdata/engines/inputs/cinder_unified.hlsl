#define SAMPLER2D(name, reg) Texture2D name##Tex : register(t##reg); SamplerState name##State : register(s##reg); static Sampler2D name = { name##Tex, name##State }
#define SAMPLERCUBE(name, reg) TextureCube name##Tex : register(t##reg); SamplerState name##State : register(s##reg); static SamplerCube name = { name##Tex, name##State }
#define IN(decl, sem) in decl : sem,
#define OUT(decl, sem) out decl : sem,
#define VS_PARAMETERS void main_vp(
#define FS_PARAMETERS void main_fp(
#define VS_DECLARATION out float4 gl_Position : SV_Position)
#define FS_DECLARATION out float4 gl_FragColor : SV_Target)
#define UNIFORMS(params) params
#define vec2 float2
#define vec3 float3
#define vec4 float4
#define mat4 float4x4
#define mix lerp
#define fract frac
struct Sampler2D { Texture2D t; SamplerState s; };
struct SamplerCube { TextureCube t; SamplerState s; };
vec4 texture2D(Sampler2D s, vec2 v) { return s.t.Sample(s.s, v); }
vec4 texture2DLod(Sampler2D s, vec2 v, float lod) { return s.t.SampleLevel(s.s, v, lod); }
vec4 textureCube(SamplerCube s, vec3 v) { return s.t.Sample(s.s, v); }
UNIFORMS(uniform mat4 worldViewProj; uniform float time; uniform vec4 colour; uniform vec4 texelOffsets;)
SAMPLER2D(noiseMap, 0);
SAMPLER2D(baseMap, 1);
SAMPLERCUBE(skyMap, 2);
VS_PARAMETERS
IN(vec4 vertex, POSITION)
IN(vec3 normal, NORMAL)
#ifdef USE_UV
IN(vec2 uv0, TEXCOORD0)
OUT(vec2 oUv, TEXCOORD0)
#endif
OUT(vec3 oNormal, TEXCOORD1)
VS_DECLARATION {
  vec4 p = vertex;
#ifdef DISPLACE
  p.y += texture2DLod(noiseMap, vertex.xz * 0.01 + fract(time), 0.0).r;
#endif
  gl_Position = mul(worldViewProj, p);
  oNormal = normal;
#ifdef USE_UV
  oUv = uv0 + texelOffsets.xy;
#endif
}
FS_PARAMETERS
#ifdef USE_UV
IN(vec2 oUv, TEXCOORD0)
#endif
IN(vec3 oNormal, TEXCOORD1)
FS_DECLARATION {
  vec4 c = colour;
#ifdef USE_UV
  c *= texture2D(baseMap, oUv);
#endif
#ifdef REFLECT
  c.rgb = mix(c.rgb, textureCube(skyMap, oNormal).rgb, c.a);
#endif
  gl_FragColor = c;
}
