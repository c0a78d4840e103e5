//83
sampler2D map = sampler_state { Texture = <picture>; };
sampler cube;
float4 main(float2 uv : TEXCOORD0, float4 color : COLOR0, float2 pixel : VPOS, float face : VFACE, out float d : DEPTH) : COLOR0 {
  d = 0.5;
  clip(color.a - 0.5);
  return tex2D(map, uv) * face + texCUBE(cube, color.xyz) + tex2Dproj(map, color) + pixel.x;
}
