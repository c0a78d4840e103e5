// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "half.hlsli"
#include "planes.hlsli"

[clipplanes(first)]
float4 one(float4 position : POSITION) : SV_Position { return HALF(position); }

#ifdef SECOND
[clipplanes(first, second)]
float4 two(float4 position : POSITION) : SV_Position { return position; }
#endif
