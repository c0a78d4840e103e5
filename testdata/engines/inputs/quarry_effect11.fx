// Effects framework of Direct3D 10 and 11, with state objects, groups and classes.
cbuffer cb0 : register(b0) { row_major float4x4 g_mWorldViewProjection; float4x4 g_mWorld; float3 g_vEye; float g_fTime; bool g_bTexture; };
cbuffer cbRare { float4 g_MaterialAmbientColor = float4(0.1, 0.2, 0.3, 1); uint2 g_Tiles; float g_Weights[5]; };
Texture2D g_txDiffuse; Texture2DArray g_txLayers; TextureCube g_txEnv; Texture3D g_txVolume;
SamplerState g_samLinear { Filter = MIN_MAG_MIP_LINEAR; AddressU = Wrap; AddressV = Wrap; };
SamplerComparisonState g_samCmp { Filter = COMPARISON_MIN_MAG_MIP_LINEAR; ComparisonFunc = LESS; };
DepthStencilState EnableDepth { DepthEnable = TRUE; DepthWriteMask = ALL; DepthFunc = LESS_EQUAL; };
BlendState NoBlending { AlphaToCoverageEnable = FALSE; BlendEnable[0] = FALSE; RenderTargetWriteMask[0] = 0x0F; };
RasterizerState Wire { FillMode = WIREFRAME; CullMode = None; };
struct VSIn { float3 pos : POSITION; float3 norm : NORMAL; float2 tex : TEXTURE0; uint id : SV_VertexID; uint inst : SV_InstanceID; };
struct VSOut { float4 pos : SV_Position; float3 norm : NORMAL; linear float2 tex : TEXTURE0; nointerpolation uint layer : LAYER; float3 dir : DIRECTION; };
float3 Wave(float3 p, float t) { float s, c; sincos(t + p.x, s, c); return float3(p.x, mad(s, 0.1, p.y), p.z * c); }
VSOut VSScene(VSIn input, uniform bool bWave) {
  VSOut output = (VSOut)0;
  float3 p = bWave ? Wave(input.pos, g_fTime) : input.pos;
  output.pos = mul(float4(p, 1), g_mWorldViewProjection);
  output.norm = mul(input.norm, (float3x3)g_mWorld);
  output.tex = input.tex + float2(input.id & 1, input.id >> 1) / g_Tiles;
  output.layer = input.inst;
  output.dir = mul(float4(p, 1), g_mWorld).xyz - g_vEye;
  return output;
}
VSOut VSMove(VSIn input) { return VSScene(input, true); }
VSOut VSStill(VSIn input) { return VSScene(input, false); }
VSOut VSFromHeight(VSIn input) { input.pos.y += g_txDiffuse.SampleLevel(g_samLinear, input.tex, 0).x; return VSScene(input, false); }
float4 Blur(float2 uv) { float4 sum = 0; [unroll] for (int i = -2; i <= 2; ++i) sum += g_Weights[i + 2] * g_txDiffuse.Sample(g_samLinear, uv, int2(i, 0)); return sum; }
float4 PSTexture(VSOut input) : SV_Target { float4 c = g_MaterialAmbientColor; [branch] if (g_bTexture) c *= g_txDiffuse.SampleLevel(g_samLinear, input.tex, 0); return c; }
float4 PSBlur(VSOut input) : SV_Target { return Blur(input.tex); }
float4 PSLayers(VSOut input) : SV_Target { return g_txLayers.Sample(g_samLinear, float3(input.tex, input.layer)) + g_txVolume.Sample(g_samLinear, input.norm); }
float4 PSEnv(VSOut input, bool front : SV_IsFrontFace) : SV_Target { float3 n = normalize(front ? input.norm : -input.norm); return g_txEnv.SampleBias(g_samLinear, reflect(input.dir, n), 1); }
float PSShadow(VSOut input) : SV_Target { return g_txDiffuse.SampleCmpLevelZero(g_samCmp, input.tex, input.pos.z); }
struct MRT { float4 a : SV_Target0; uint2 b : SV_Target1; float depth : SV_Depth; };
MRT PSMany(VSOut input) { MRT o; o.a = input.pos; o.b = uint2(asuint(input.dir.x), input.layer); o.depth = saturate(input.pos.z * .5); return o; }
technique11 Render <bool shadows = true;> {
  pass P0 { SetVertexShader(CompileShader(vs_5_0, VSScene(true))); SetGeometryShader(NULL); SetPixelShader(CompileShader(ps_5_0, PSTexture())); SetBlendState(NoBlending, float4(0, 0, 0, 0), 0xFFFFFFFF); SetDepthStencilState(EnableDepth, 0); SetRasterizerState(Wire); }
}
fxgroup g0 { technique11 Blurred { pass { SetVertexShader(CompileShader(vs_4_0, VSStill())); SetPixelShader(CompileShader(ps_4_0, PSBlur())); } } }
