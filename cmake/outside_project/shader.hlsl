// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "planes.hlsli"

#ifndef SCALE
#define SCALE 1
#endif

[clipplanes(first, second)]
float4 main(float4 position : POSITION) : SV_Position { return SCALE * position; }
float4 pixel() : SV_Target { return 1; }

float4 ps(float4 position : SV_Position) : SV_Target { return position.xyxy * SCALE; }

RWBuffer<uint> to;
[numthreads(64, 1, 1)] void cs(uint i : SV_DispatchThreadID) { to[i] = SCALE * i; }
