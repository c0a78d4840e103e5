#define REGISTER(_type, _reg) register(_type ## _reg)
#define SAMPLER2D(_name, _reg) uniform SamplerState _name ## Sampler : REGISTER(s, _reg); uniform Texture2D _name ## Texture : REGISTER(t, _reg); static LanternSampler2D _name = { _name ## Sampler, _name ## Texture }
#define SAMPLER2DSHADOW(_name, _reg) uniform SamplerComparisonState _name ## SamplerComparison : REGISTER(s, _reg); uniform Texture2D _name ## Texture : REGISTER(t, _reg); static LanternSampler2DShadow _name = { _name ## SamplerComparison, _name ## Texture }
#define texture2D(_sampler, _coord) lanternTexture2D(_sampler, _coord)
#define shadow2D(_sampler, _coord) lanternShadow2D(_sampler, _coord)
#define vec2_splat(_x) float2(_x, _x)
#define vec3_splat(_x) float3(_x, _x, _x)
#define mtxFromCols(_0, _1, _2) transpose(float3x3(_0, _1, _2))
#define dFdx(_x) ddx(_x)
#define dFdy(_y) ddy(-(_y))
#define NORMAL_SLOT 1
typedef float3 vec3; typedef float4 vec4; typedef float2 vec2; typedef float4x4 mat4; typedef int4 ivec4;
struct LanternSampler2D { SamplerState m_sampler; Texture2D m_texture; };
struct LanternSampler2DShadow { SamplerComparisonState m_sampler; Texture2D m_texture; };
vec4 lanternTexture2D(LanternSampler2D _sampler, vec2 _coord) { return _sampler.m_texture.Sample(_sampler.m_sampler, _coord); }
float lanternShadow2D(LanternSampler2DShadow _sampler, vec3 _coord) { return _sampler.m_texture.SampleCmpLevelZero(_sampler.m_sampler, _coord.xy, _coord.z); }
vec4 vec4_splat0() { return vec4(0.0, 0.0, 0.0, 0.0); }
uniform mat4 u_modelViewProj; uniform mat4 u_model[32]; uniform vec4 u_lightDir; uniform vec4 u_params[3];
SAMPLER2D(s_texColor, 0);
SAMPLER2D(s_texNormal, NORMAL_SLOT);
SAMPLER2DSHADOW(s_shadowMap, 2);
struct Output { vec4 gl_Position : SV_POSITION; vec4 v_color0 : COLOR0; vec3 v_normal : NORMAL; vec2 v_texcoord0 : TEXCOORD0; };
Output vsmain(vec3 a_position : POSITION, vec3 a_normal : NORMAL, vec4 a_color0 : COLOR0, vec2 a_texcoord0 : TEXCOORD0, ivec4 a_indices : BLENDINDICES) {
  Output _varying_;
  _varying_.v_color0 = a_color0;
#ifdef SKINNED
  vec4 wpos = mul(u_model[a_indices.x], vec4(a_position, 1.0));
#else
  vec4 wpos = vec4(a_position, 1.0);
#endif
  _varying_.gl_Position = mul(u_modelViewProj, wpos);
  _varying_.v_normal = a_normal * 2.0 - 1.0;
  _varying_.v_texcoord0 = a_texcoord0 * u_params[0].xy;
  return _varying_;
}
void psmain(vec4 gl_FragCoord : SV_POSITION, vec4 v_color0 : COLOR0, vec3 v_normal : NORMAL, vec2 v_texcoord0 : TEXCOORD0, out vec4 lantern_FragData0 : SV_TARGET0) {
  vec4 lantern_VoidFrag = vec4_splat0();
  vec3 n = normalize(v_normal);
#if BUMP
  vec3 e = cross(dFdx(n), dFdy(n));
  n = mul(mtxFromCols(e, vec3_splat(0.5), n), texture2D(s_texNormal, v_texcoord0).xyz);
#endif
  float lit = saturate(dot(n, u_lightDir.xyz));
#if SHADOWS
  lit *= shadow2D(s_shadowMap, vec3(v_texcoord0, gl_FragCoord.z));
#endif
  lantern_FragData0 = texture2D(s_texColor, v_texcoord0) * v_color0 * lit + lantern_VoidFrag;
}
