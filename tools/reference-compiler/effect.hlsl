// An effect file: the reference compiler gets what the entry function needs of it, without what only effects have.
#define SCALE(x) ((x) * 2.0f)

float4x4 world : WORLD <
  bool SasUiVisible = false;
  string SasBindAddress = "Sas.Skeleton[0]";
>;
int version : VERSION < int3 SasVersion = {1, 1, 0}; >;
float4 tint < string UIName = "tint"; > = {0.5f, 0.25f, 1e-3f, 1.0f};
struct Light {
  float3 place;
} light;
texture scene < string name = "scene.dds"; >;
sampler2D scene_sampler = sampler_state {
  Texture = <scene>;
  MinFilter = LINEAR;
};
SamplerState plain {
  Filter = MIN_MAG_MIP_POINT;
};
BlendState blending {
  BlendEnable[0] = TRUE;
};

float4 shade(float4 color) { return SCALE(color) + light.place.xyzz; }

struct Output {
  float4 position : SV_Position;
  float3 color : COLOR;
};

Output RenderVS(float4 position : POSITION) {
  Output result;
  result.position = mul(position, world) + version;
  result.color = shade(tint * position.w).rgb;
  return result;
}

float4 RenderPS(Output input) : SV_Target { return tex2D(scene_sampler, input.color.xy); }

technique10 Render {
  pass P0 {
    SetVertexShader(CompileShader(vs_4_0, RenderVS()));
    SetPixelShader(CompileShader(ps_4_0, RenderPS()));
    SetBlendState(blending, float4(0, 0, 0, 0), 0xFFFFFFFF);
  }
}
