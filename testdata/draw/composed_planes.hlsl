// Planes that are no whole register; Direct3D 9 could not be told.
// RUN: %draw compare %s -T vs_5_0 -E main --lower clip-distance,none

float4 a, b;
float4x4 m;
row_major float4x4 r;

[clipplanes(a.wzyx, float4(a.xy, b.zw), b.yyyy, m[1], r[2])]
float4 main(float4 position : POSITION) : SV_Position { return position + a; }
