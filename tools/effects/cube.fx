// Direct3D 9: a cube map, whose faces are red, cyan, green, magenta, blue and yellow.
// DRAW Cube X
// PIXEL 8 8 = 255 0 0 255
// DRAW Cube Y
// PIXEL 8 8 = 255 0 255 255
// DRAW Cube Z
// PIXEL 8 8 = 0 0 255 255
texture Sky : ENVIRONMENT;
samplerCUBE SkySampler = sampler_state { Texture = <Sky>; MinFilter = Linear; MagFilter = Linear; MipFilter = None; };
float4 VS(float4 p : POSITION) : POSITION { return p; }
float4 PS(uniform float3 direction) : COLOR { return texCUBE(SkySampler, direction); }
#define FACE(name, direction) pass name { VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(direction); }
technique Cube { FACE(X, float3(1, 0, 0)) FACE(Y, float3(0, -1, 0)) FACE(Z, float3(0, 0, 1)) }
