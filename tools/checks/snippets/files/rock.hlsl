struct Varyings { float4 position : SV_Position; float3 normal : NORMAL; int material : MATERIAL; };
Varyings main(Varyings vertex) { return vertex; }
