// An effect of Direct3D 9's framework. Its vertex shaders are of feature level 9, so that their planes are declared in the shader:
// what SetClipPlane was for.
float4x4 World : WORLD;
float4x4 ViewProjection : VIEWPROJECTION;
float4 WaterPlane;  // in clip space
float4 Color <string UIName = "Color";> = {0.8, 0.45, 0.25, 1.0};
float3 LightDirection = {0.4, 0.8, -0.45};
float Waves = 0.35;

texture Map;
sampler MapSampler = sampler_state {
  Texture = <Map>;
  MinFilter = Linear;
  MagFilter = Linear;
  AddressU = Wrap;
  AddressV = Wrap;
};

struct Varyings {
  float4 position : SV_Position;
  float3 normal : TEXCOORD0;
  float2 place : TEXCOORD1;
};

Varyings Transform(float3 position, float3 normal) {
  Varyings v;
  const float4 world = mul(float4(position, 1), World);
  v.position = mul(world, ViewProjection);
  v.normal = mul(normal, (float3x3)World);
  v.place = world.xz;
  return v;
}

Varyings VS(float3 position : POSITION, float3 normal : NORMAL) { return Transform(position, normal); }

[clipplanes(WaterPlane)]
Varyings AboveWaterVS(float3 position : POSITION, float3 normal : NORMAL) { return Transform(position, normal); }

float4 PS(Varyings v, uniform float bright) : COLOR {
  const float diffuse = saturate(dot(normalize(v.normal), normalize(LightDirection)));
  return float4(Color.rgb * (0.35 + 0.65 * diffuse) * bright, 1);
}

float4 SurfacePS(Varyings v) : COLOR {
  const float wave = tex2D(MapSampler, v.place * Waves).r;
  return float4(0.10, 0.25 + 0.1 * wave, 0.35 + 0.1 * wave, 0.55);
}

technique Lake {
  pass Reflection {  // mirrored, so that the winding is turned
    CullMode = CCW;
    VertexShader = compile vs_4_0_level_9_1 AboveWaterVS();
    PixelShader = compile ps_4_0_level_9_1 PS(0.8);
  }
  pass Surface {
    CullMode = None;
    AlphaBlendEnable = true;
    SrcBlend = SrcAlpha;
    DestBlend = InvSrcAlpha;
    VertexShader = compile vs_4_0_level_9_1 VS();
    PixelShader = compile ps_4_0_level_9_1 SurfacePS();
  }
  pass Objects {  // the triangles of the meshes are counterclockwise
    CullMode = CW;
    VertexShader = compile vs_4_0_level_9_1 VS();
    PixelShader = compile ps_4_0_level_9_1 PS(1);
  }
}
