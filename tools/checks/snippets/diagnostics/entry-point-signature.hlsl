// clipc water.hlsl -T vs_5_0
float4 main(float4 p : POSITION, float2 uv) : SV_Position { return p + uv.xyxy; }
