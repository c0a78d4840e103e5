// Direct3D 9: address modes and the border color; coordinates from -1 to 2.
// DRAW Modes Clamp
// PIXEL 1 1 = 255 0 0 255
// PIXEL 14 1 = 0 255 0 255
// DRAW Modes Border
// PIXEL 1 1 = 0 128 255 255
// PIXEL 6 6 = 255 0 0 255
// DRAW Modes Mirror
// PIXEL 4 6 = 255 0 0 255
// PIXEL 1 6 = 0 255 0 255
// DRAW Modes Wrap
// PIXEL 1 6 = 255 0 0 255
texture Map;
#define MODE(name, mode) sampler name = sampler_state { Texture = (Map); MinFilter = POINT; MagFilter = POINT; AddressU = mode; AddressV = mode; BorderColor = 0xFF0080FF; }
MODE(Clamped, CLAMP);
MODE(Bordered, BORDER);
MODE(Mirrored, MIRROR);
MODE(Wrapped, WRAP);
void VS(inout float4 p : POSITION, inout float2 uv : TEXCOORD0) { uv = uv * 3 - 1; }
float4 PS(float2 uv : TEXCOORD0, uniform sampler from) : COLOR { return tex2D(from, uv); }
#define PASS(name, from) pass name { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PS(from); }
technique Modes { PASS(Clamp, Clamped) PASS(Border, Bordered) PASS(Mirror, Mirrored) PASS(Wrap, Wrapped) }
