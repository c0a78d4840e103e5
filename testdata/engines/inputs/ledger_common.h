// Names and packings that every shader of this style includes.
#ifndef LEDGER_COMMON
#define LEDGER_COMMON
#define cat2(a, b) a##b
#define cat(a, b) cat2(a, b)
#define c_slot(n) register(cat(c, n))
#define FOG_SLOT 20
#define SUN_SLOT 21
uniform float4x4 m_world_view_proj : register(c0);
uniform float4x4 m_world : register(c4);
uniform float3x4 m_view : register(c8);
uniform float4 fog_plane : c_slot(FOG_SLOT);
uniform float4 sun_color : c_slot(SUN_SLOT);
uniform float4 array_wind[8] : register(c30);
struct v_static { float4 P : POSITION; float4 N : NORMAL; float4 T : TANGENT; int2 tc : TEXCOORD0; };
struct v_lightmap { float4 P : POSITION; float4 N : NORMAL; float2 tc0 : TEXCOORD0; float2 tc1 : TEXCOORD1; };
struct p_static { float4 hpos : POSITION; float2 tc : TEXCOORD0; float3 n : TEXCOORD1; float fog : FOG; float4 c0 : COLOR0; };
float3 unpack_normal(float3 v) { return 2 * v - 1; }
float2 unpack_tc(int2 tc) { return tc * (32.f / 32768.f); }
float calc_fog(float4 p) { return saturate(dot(p, fog_plane)); }
#endif
