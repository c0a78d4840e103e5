// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A shader for every plane that the application may set; what a scene needs of it are its variants.
float4x4 world_view_projection;
cbuffer Clip { float4 planes[3]; };

[clipplanes(planes[0], planes[1], planes[2])]
float4 main(float4 position : POSITION) : SV_Position { return mul(position, world_view_projection); }
