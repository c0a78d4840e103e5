//70
Texture2D map : register(t0);
SamplerState state;
cbuffer C { float4 tint; uint4 flags; };
struct In { float4 p : SV_Position; float2 uv : TEXCOORD0; nointerpolation uint id : ID; bool front : SV_IsFrontFace; };
struct Out { float4 color : SV_Target0; uint2 ids : SV_Target1; float depth : SV_Depth; };
Out main(In i) {
  Out o;
  clip(map.Sample(state, i.uv).a - tint.a);
  if (i.id == flags.x) discard;
  o.color = i.front ? map.SampleBias(state, i.uv, 1) : tint * ddx(i.p.y);
  o.ids = uint2(i.id, flags.y);
  o.depth = i.p.z + fwidth(i.uv.x);
  return o;
}
