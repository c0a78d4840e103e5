// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A dome at the far plane that turns with the camera but does not move.
// clipc -T vs_4_0
cbuffer Camera {
  float4x4 view;
  float4x4 projection;
};

float4 main(float3 direction : POSITION, out float3 ray : TEXCOORD) : SV_Position {
  ray = direction;
  float3 turned = mul(direction, (float3x3)view);
  return mul(float4(turned, 1), projection).xyww;
}
