// What translators from GLSL and SPIR-V write.
#ifdef FROM_SPIRV
cbuffer type_Globals : register(b0) { row_major float4x4 _16_mvp : packoffset(c0); float4 _16_colors[2] : packoffset(c4); int _16_count : packoffset(c6); };
Texture2D<float4> _31 : register(t1);
SamplerState __31_sampler : register(s1);
static float4 gl_Position;
static int gl_VertexIndex;
static float4 _9;
static float2 _11;
static float2 _13;
static float4 _44;
struct SPIRV_Cross_Input { float4 _9 : TEXCOORD0; float2 _11 : TEXCOORD1; uint gl_VertexIndex : SV_VertexID; };
struct SPIRV_Cross_Output { float2 _13 : TEXCOORD0; float4 gl_Position : SV_Position; };
struct FragIn { float2 _13 : TEXCOORD0; };
struct FragOut { float4 _44 : SV_Target0; };
float mod(float x, float y) { return x - y * floor(x / y); }
void vert_main() {
  gl_Position = mul(_9, _16_mvp);
  for (int _50 = 0; _50 < _16_count; _50++) { gl_Position += _16_colors[_50 & 1]; continue; }
  _13 = float2(mod(_11.x, 1.0f), float(gl_VertexIndex));
}
SPIRV_Cross_Output main(SPIRV_Cross_Input stage_input) {
  gl_VertexIndex = int(stage_input.gl_VertexIndex);
  _9 = stage_input._9;
  _11 = stage_input._11;
  vert_main();
  SPIRV_Cross_Output stage_output;
  stage_output.gl_Position = gl_Position;
  stage_output._13 = _13;
  return stage_output;
}
void frag_main() { do { float4 _60 = _31.Sample(__31_sampler, _13); if (_60.w < 0.5f) { _44 = 0.0f.xxxx; break; } _44 = _60; break; } while (false); }
FragOut fragment(FragIn stage_input) { _13 = stage_input._13; frag_main(); FragOut stage_output; stage_output._44 = _44; return stage_output; }
#else
float4 vec4_ctor(float3 x0, float x1) { return float4(x0, x1); }
static float4 _a_position = {0, 0, 0, 0};
static float2 _a_uv = {0, 0};
static float2 _v_uv = {0, 0};
uniform float4x4 _u_mvp : register(c0);
uniform float4 _u_tint : register(c4);
static float4 gl_Position = float4(0, 0, 0, 0);
static float4 gl_Color[1] = { float4(0, 0, 0, 0) };
cbuffer DriverConstants : register(b1) { float4 dx_ViewAdjust : packoffset(c1); float2 dx_ViewCoords : packoffset(c2); };
static const uint _s_index = 1;
uniform Texture2D<float4> textures2D[2] : register(t0);
uniform SamplerState sampler_s_map : register(s0);
float4 gl_texture2D(Texture2D<float4> map, SamplerState samp, float2 t) { return map.Sample(samp, float2(t.x, t.y)); }
struct VS_INPUT { float4 _a_position : TEXCOORD0; float2 _a_uv : TEXCOORD1; };
struct VS_OUTPUT { float4 dx_Position : SV_Position; float4 gl_Position : TEXCOORD1; float2 v0 : TEXCOORD0; };
void gl_main() { (gl_Position = mul(transpose(_u_mvp), vec4_ctor(_a_position.xyz, 1.0))); (_v_uv = _a_uv); }
VS_OUTPUT main(VS_INPUT input) {
  _a_position = input._a_position;
  _a_uv = input._a_uv;
  gl_main();
  VS_OUTPUT output;
  output.gl_Position = gl_Position;
  output.dx_Position.x = gl_Position.x;
  output.dx_Position.y = - gl_Position.y;
  output.dx_Position.z = (gl_Position.z + gl_Position.w) * 0.5;
  output.dx_Position.w = gl_Position.w;
  output.v0 = _v_uv;
  return output;
}
struct PS_INPUT { float4 dx_Position : SV_Position; float4 gl_Position : TEXCOORD1; float2 v0 : TEXCOORD0; };
struct PS_OUTPUT { float4 gl_Color0 : SV_TARGET0; };
void gl_psmain() { (gl_Color[0] = (gl_texture2D(textures2D[_s_index], sampler_s_map, _v_uv) * _u_tint)); if ((_v_uv.x > 0.5)) { (gl_Color[0].xyz *= 0.5); } }
PS_OUTPUT fragment(PS_INPUT input) { _v_uv = input.v0.xy; gl_psmain(); PS_OUTPUT output; output.gl_Color0 = gl_Color[0]; return output; }
#endif
