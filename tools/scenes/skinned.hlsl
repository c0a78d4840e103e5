// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The objects of scene.hlsl, moved by bones and lit by lights: loops whose iterations Direct3D 9's shaders have no index for, so that
// fxc unrolls them under feature level 9, and with them `uniform` parameters, which are known where a function is called.
cbuffer Draw : register(b0) {
  row_major float4x4 bones[2];
  float4 indices;
  float4 weights;
  float4 lights[3];
  float4 pixel_offset;
};

cbuffer Planes : register(b1) {
  float4 planes[3];
};

struct Output {
  float4 position : SV_Position;
  float4 color : COLOR;
};

float4x4 Skin(uniform int count) {
  float4x4 skin = 0;
  [unroll] for (int i = 0; i < count; ++i) skin += bones[indices[i]] * weights[i];
  return skin;
}

float3 Light(float3 color, uniform int count) {
  float3 lit = 0;
  [unroll] for (int i = 0; i < count; ++i) lit[i] = dot(lights[i].xyz, color);
  return lit;
}

[clipplanes(planes[2], planes[0], planes[1])]
Output main(float3 position : POSITION, float4 color : COLOR) {
  Output output;
  output.position = mul(float4(position, 1), Skin(2));
  output.position.xy += pixel_offset.xy * output.position.ww;
  output.color = float4(Light(color.rgb, 3), color.a);
  return output;
}
