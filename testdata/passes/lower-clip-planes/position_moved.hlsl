// Plane space `object` clips the vertex as it comes in; a shader that moves it first gets a warning.
// RUN: %clipc --plane-space=object -DSKIN %s -o %t.vert 2>&1 | FileCheck %s --check-prefix=SKIN
// RUN: %clipc --plane-space=object -DINSTANCE %s -o %t.vert 2>&1 | FileCheck %s --check-prefix=INSTANCE
// RUN: %clipc --plane-space=object -DWAVE %s -o %t.vert 2>&1 | FileCheck %s --check-prefix=WAVE
// RUN: %clipc --plane-space=object -DHEIGHT %s -o %t.vert 2>&1 | FileCheck %s --check-prefix=WAVE
// RUN: %clipc --plane-space=object -DSKIN -Wno-position-input-moved -Werror %s -o %t.vert
//
// Matrices alone, whatever they are, and what does not reach the position, are no movement.
// RUN: %clipc --plane-space=object -DRIGID -Werror %s -o %t.vert
// RUN: %clipc --plane-space=xyw1 -DSKIN -Werror %s -o %t.vert
// RUN: %clipc --plane-space=object -Werror %S/../../../examples/gallery/water_reflection.hlsl -o %t.vert
// RUN: %clipc --plane-space=object -Werror -T vs_5_1 %S/../../../examples/gallery/portal.hlsl -o %t.vert

cbuffer Frame {
  float4x4 world, view_projection;
  float4x4 bones[4];
  float4 plane;
  float time;
};
Texture2D heights;
SamplerState linear_sampler;

struct Input {
  float3 position : POSITION;
  float2 uv : TEXCOORD;
  uint4 bone : BLENDINDICES;
  uint instance : SV_InstanceID;
};

[clipplanes(plane)]
float4 main(Input input, out float2 uv : TEXCOORD) : SV_Position {
  // SKIN: position_moved.hlsl:[[#@LINE-8]]:21: warning: the position is not the input `POSITION0` times matrices: it depends on `BLENDINDICES0` too; plane space `object` clips by the unchanged input [-Wposition-input-moved]
  // INSTANCE: warning: the position is not the input `POSITION0` times matrices: it depends on `SV_InstanceID` too;
  // WAVE: warning: {{.*}} times matrices: the middle of two vertices is not drawn in the middle;
  uv = input.uv + float2(input.bone.xy);
  float4 moved = float4(input.position, 1);
#if defined SKIN
  moved = mul(moved, bones[input.bone.x]);
#elif defined INSTANCE
  moved.x += 2 * input.instance;
#elif defined WAVE
  moved.y += sin(moved.x + time);
#elif defined HEIGHT
  moved.y += heights.SampleLevel(linear_sampler, moved.xz, 0).x;
#endif
  return mul(mul(moved, world), view_projection);
}
