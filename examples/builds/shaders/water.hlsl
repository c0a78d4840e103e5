// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "planes.hlsli"

[clipplanes(water_plane)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
