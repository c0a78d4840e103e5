// Effects of Direct3D 11: a group of techniques, shader variables, and a class whose instance is known.
// DRAW Lit
// PIXEL 8 8 = 64 128 191 255
// DRAW Dark
// PIXEL 8 8 = 0 0 0 255
interface Light { float3 Color(float3 base); };
class Lamp : Light { float3 Color(float3 base) { return base * 0.5; } };
class Off : Light { float3 Color(float3 base) { return 0; } };
Lamp lamp;
Off off;
float4 VS(float4 p : POSITION) : SV_Position { return p; }
float4 PSLamp() : SV_Target { return float4(lamp.Color(float3(0.5, 1, 1.5)), 1); }
float4 PSOff() : SV_Target { return float4(off.Color(1), 1); }
VertexShader Vertex = CompileShader(vs_5_0, VS());
PixelShader LitPixel = CompileShader(ps_5_0, PSLamp());
fxgroup Lights {
  technique11 Lit { pass P0 { SetVertexShader(Vertex); SetPixelShader(LitPixel); } }
  technique11 Dark { pass P0 { SetVertexShader(Vertex); SetPixelShader(CompileShader(ps_5_0, PSOff())); } }
}
