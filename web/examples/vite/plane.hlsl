// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
cbuffer Draw : register(b0) {
  float4x4 to_clip;
  float4 plane;
};

[clipplanes(plane)]
float4 main(float3 position : POSITION) : SV_Position {
  return mul(float4(position, 1), to_clip);
}
