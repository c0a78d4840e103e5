// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A Direct3D 9 effect: techniques, state blocks and the pixel shader are none of the vertex shader's business.
// clipc -T vs_3_0 -E VertexMain
float4x4 WorldViewProjection : WORLDVIEWPROJECTION;
float4 LightDirection = float4(0, -1, 0, 0);
float4 Ambient, Diffuse;
texture ColorMap;
sampler ColorSampler = sampler_state { Texture = <ColorMap>; MinFilter = Linear; };

struct VS_OUTPUT {
  float4 Position : POSITION;
  float4 Color : COLOR0;
  float2 TexCoord : TEXCOORD0;
};

VS_OUTPUT VertexMain(float4 position : POSITION, float3 normal : NORMAL, float2 uv : TEXCOORD0) {
  VS_OUTPUT output;
  output.Position = mul(position, WorldViewProjection);
  output.Color = Ambient + Diffuse * saturate(dot(normal, -LightDirection.xyz));
  output.TexCoord = uv;
  return output;
}

float4 PixelMain(VS_OUTPUT input) : COLOR { return tex2D(ColorSampler, input.TexCoord) * input.Color; }

technique Lit {
  pass P0 {
    VertexShader = compile vs_3_0 VertexMain();
    PixelShader = compile ps_3_0 PixelMain();
  }
}
