// XNA's stock effects: one index chooses both shaders, through arrays of integers.
// DRAW T P.0
// PIXEL 8 8 = 255 0 0 255
// DRAW T P.1
// PIXEL 8 8 = 0 128 0 255
// DRAW T P.2
// PIXEL 8 8 = 255 0 0 255
// DRAW T P.3
// PIXEL 8 8 = 0 64 0 255
struct Plain { float4 position : POSITION0; };
struct Lit { float4 position : POSITION0; float4 color : COLOR0; };
Plain VSPlain(float4 p : POSITION0) { Plain o; o.position = p; return o; }
Lit VSLit(float4 p : POSITION0) { Lit o; o.position = p; o.color = float4(0, 0.5, 0, 1); return o; }
Lit VSDark(float4 p : POSITION0) { Lit o; o.position = p; o.color = float4(0, 0.25, 0, 1); return o; }
float4 PSPlain() : SV_Target0 { return float4(1, 0, 0, 1); }
float4 PSLit(float4 color : COLOR0) : SV_Target0 { return color; }
VertexShader VSArray[3] = { compile vs_2_0 VSPlain(), compile vs_2_0 VSLit(), compile vs_2_0 VSDark() };
PixelShader PSArray[2] = { compile ps_2_0 PSPlain(), compile ps_2_0 PSLit() };
int VSIndices[4] = { 0, 1, 0, 2 };
int PSIndices[4] = { 0, 1, 0, 1 };
int ShaderIndex = 0;
Technique T { Pass P { VertexShader = (VSArray[VSIndices[ShaderIndex]]); PixelShader = (PSArray[PSIndices[ShaderIndex]]); } }
