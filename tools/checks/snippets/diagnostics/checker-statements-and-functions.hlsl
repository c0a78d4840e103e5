// clipc water.hlsl
float height(float x) { if (x > 0) return x; }
float4 main(float4 p : POSITION) : SV_Position { return p * height(p.x); }
