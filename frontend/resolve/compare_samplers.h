// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>

#include "frontend/resolve/names.h"

namespace clipc::resolve {

// Makes each sampler with one of these names one that compares: in Direct3D 9 the driver compares a
// texture of a depth format (D3DFMT_D16, D24S8, ..) with the third coordinate of the read, less or
// equal, and gives the result in all four components. The HLSL does not show it.
//
//   sampler2D s;                        sampler2DShadow s;
//   tex2Dproj(s, p)                 =>  float4 of (s, p), compared with p.z / p.w
//   tex2Dlod(s, float4(u, v, z, l)) =>  float4 of (s, (u, v, z), l), compared with z; tex2Dbias too
//
// Source: DXVK's dxso_compiler.cpp (SampleImage), where the reference is the component after the
// coordinates, divided by w if the read is projected, and Microsoft's page on
// D3D11_FEATURE_DATA_D3D9_SHADOW_SUPPORT: less or equal. tex2D and tex2Dgrad have two coordinates
// in HLSL, so that the driver compares whatever the register holds after them: these are errors,
// ShadowSamplerPlace. Others are a sampler of another kind (ShadowSamplerKind) and one that a
// method reads (ShadowSamplerMethod). Warns of a name that no sampler has, ShadowSamplerUnknown.
// Requires SettleSamplers.
void CompareSamplers(Program& program, std::span<const std::string> names,
                     Diagnostics& diagnostics);

}  // namespace clipc::resolve
