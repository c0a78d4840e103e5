// Effects of Direct3D 10: blocks of states, and the calls that set them.
// DRAW Render Opaque
// DRAW Render Blended
// PIXEL 8 8 = 128 0 128 255
// DRAW Render Behind
// PIXEL 8 8 = 128 0 128 255
// DRAW Render Factor
// PIXEL 8 8 = 64 191 64 255
// DRAW Render Culled
// PIXEL 8 8 = 64 191 64 255
BlendState NoBlend { BlendEnable[0] = FALSE; };
BlendState Over { BlendEnable[0] = TRUE; SrcBlend = SRC_ALPHA; DestBlend = INV_SRC_ALPHA; BlendOp = ADD; SrcBlendAlpha = ONE; DestBlendAlpha = ONE; BlendOpAlpha = ADD; RenderTargetWriteMask[0] = 0x0F; };
BlendState Factor { BlendEnable[0] = TRUE; SrcBlend = BLEND_FACTOR; DestBlend = INV_BLEND_FACTOR; SrcBlendAlpha = ZERO; DestBlendAlpha = ONE; };
DepthStencilState NoDepth { DepthEnable = FALSE; DepthWriteMask = ZERO; };
DepthStencilState Depth { DepthEnable = TRUE; DepthWriteMask = ALL; DepthFunc = LESS; };
RasterizerState Back { CullMode = BACK; FrontCounterClockwise = FALSE; };
RasterizerState Turned { CullMode = BACK; FrontCounterClockwise = TRUE; };
float4 VS(float4 p : POSITION) : SV_Position { return p; }
float4 PS(uniform float4 c) : SV_Target { return c; }
#define SHADERS(c) SetVertexShader(CompileShader(vs_4_0, VS())); SetGeometryShader(NULL); SetPixelShader(CompileShader(ps_4_0, PS(c)));
technique10 Render {
  pass Opaque { SHADERS(float4(1, 0, 0, 1)) SetBlendState(NoBlend, float4(0, 0, 0, 0), 0xFFFFFFFF); SetDepthStencilState(Depth, 0); SetRasterizerState(Back); }
  pass Blended { SHADERS(float4(0, 0, 1, 0.5)) SetBlendState(Over, float4(0, 0, 0, 0), 0xFFFFFFFF); SetDepthStencilState(NoDepth, 0); }
  pass Behind { SHADERS(float4(0, 1, 0, 1)) SetDepthStencilState(Depth, 0); SetBlendState(NoBlend, float4(0, 0, 0, 0), 0xFFFFFFFF); }
  pass Factor { SHADERS(float4(0, 1, 0, 1)) SetDepthStencilState(NoDepth, 0); SetBlendState(Factor, float4(0.5, 0.75, 0.5, 0.5), 0xFFFFFFFF); }
  pass Culled { SHADERS(float4(1, 1, 1, 1)) SetDepthStencilState(NoDepth, 0); SetRasterizerState(Turned); }
}
