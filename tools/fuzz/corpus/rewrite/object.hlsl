//02
cbuffer Clip { float4 plane; float4x4 m; };
struct In { float3 p : POSITION; };
[clipplanes(plane)] float4 main(In i) : SV_POSITION { return mul(m, float4(i.p, 1)); }
@ `what clipc does not know
