// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
cbuffer Clip : register(b1) { float4 water_plane; };
