//3
cbuffer C { float4 planes[5]; };
struct V { float4 p : SV_Position; nointerpolation uint id : ID; float2x2 m : TEXCOORD1; };
[clipplanes(planes[0], planes[1], planes[4])]
V main(float4 p : POSITION) { V v = (V)0; v.p = p; return v; }
[shader("pixel")] float4 pixel(uint id : ID) : SV_Target { return id; }
