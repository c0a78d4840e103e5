// clipc water.hlsl
struct Wave { float height; Wave next; };
float4 main(float4 p : POSITION) : SV_Position { return p; }
