sampler2D map;
float4 main(float4 p : TEXCOORD0) : COLOR { return tex2Dproj(map, p); }
