// Under level 9 what is known once loops are unrolled and functions are inlined may index local arrays and
// vectors. The shader draws the same as under vs_5_0.
// RUN: %clipc -T vs_4_0_level_9_1 --lower=level9 --table=%t.json --validate %s -o %t.vert
// RUN: %draw compare %s -T vs_4_0_level_9_1
cbuffer Scene {
  float4x4 view_projection;
  float4 plane;
  float4 light_direction[3];
  float4 light_color[3];
  float4x3 bones[20];
};

struct Light { float3 diffuse; };

// A bound that each call gives as a constant, and arrays and rows that the counter indexes.
Light ComputeLights(float3 normal, uniform int count) {
  float3x3 directions = 0;
  float3 colors[3] = {(float3)0, (float3)0, (float3)0};
  [unroll] for (int i = 0; i < count; i++) {
    directions[i] = light_direction[i].xyz;
    colors[i] = light_color[i].rgb;
  }
  float3 facing = saturate(mul(directions, normal));
  Light light;
  light.diffuse = 0;
  [unroll] for (int j = 0; j < count; ++j) {
    const int back = count - 1 - j;
    light.diffuse += facing[back] * colors[back];
  }
  return light;
}

// Components of a vector, and an index that is read from one.
float3 Skin(float4 position, int4 indices, float4 weights, const int count) {
  float3 skinned = 0;
  [unroll] for (int i = 0; i < count; i += 1) {
    const int bits = ~(i << 1) & 3;
    skinned *= 1 + 0 * weights[bits];
    skinned += mul(position, bones[indices[i]]) * weights[i];
  }
  return skinned;
}

[clipplanes(plane)]
float4 main(float4 position : POSITION, float3 normal : NORMAL, int4 indices : BLENDINDICES,
            float4 weights : BLENDWEIGHT, out float3 one : COLOR0, out float3 three : COLOR1) : SV_Position {
  const float3 skinned = Skin(position, abs(indices) % 20, weights, 2) + Skin(position, 0, weights, 4);
  one = ComputeLights(normal, 1).diffuse;
  three = ComputeLights(normal, 3).diffuse;
  return mul(float4(skinned, 1), view_projection);
}
