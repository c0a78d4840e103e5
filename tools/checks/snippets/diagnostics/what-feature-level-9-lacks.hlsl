// clipc water.hlsl -T vs_4_0_level_9_1
float4 main(float4 p : POSITION, uint mask : MASK) : SV_Position { return p * (mask & 3); }
