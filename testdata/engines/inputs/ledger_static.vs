#include "ledger_common.h"
#define skin_slot(n) c_slot(n)
float4 bones[24] : skin_slot(60);
#ifdef SKINNED
struct v_skin { v_static s; float4 w : BLENDWEIGHT; int4 i : BLENDINDICES; };
v_static skinned(v_skin v) {
  v_static r = v.s;
  float4 m0 = bones[v.i.x * 3 + 0], m1 = bones[v.i.x * 3 + 1], m2 = bones[v.i.x * 3 + 2];
  r.P = float4(dot(m0, v.s.P), dot(m1, v.s.P), dot(m2, v.s.P), 1);
  r.N.xyz = lerp(r.N.xyz, float3(dot(m0.xyz, r.N.xyz), dot(m1.xyz, r.N.xyz), dot(m2.xyz, r.N.xyz)), v.w.x);
  return r;
}
p_static main(v_skin source) {
  v_static v = skinned(source);
#else
p_static main(v_static v) {
#endif
  p_static o;
#ifdef WAVING
  float3 dir = array_wind[(int)v.N.w].xyz;
  v.P.xz += calc_fog(v.P) * dir.xz;
#endif
  o.hpos = mul(m_world_view_proj, v.P);
  o.n = mul((float3x3)m_world, unpack_normal(v.N.xyz));
  o.tc = unpack_tc(v.tc);
  o.fog = calc_fog(v.P);
  o.c0 = sun_color * saturate(o.n.y) + half4(v.T.www, 0);
  return o;
}
