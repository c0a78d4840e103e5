// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/resolve/names.h"

namespace clipc::resolve {

// Gives each `sampler` of the shader the kind that its uses need: Direct3D 9's functions read a
// texture with it, tex2D(s, uv), and methods sample another texture, t.Sample(s, uv). Where a
// sampler is used in several ways, each further kind of texture becomes a resource of its own with
// the name of the sampler. From shader model 4 on its register is before those of the textures, as
// fxc's is (vkd3d's combined-samplers.shader_test, checked against native):
//
//   Texture2D t;       // t0                Texture2D t;   // t1
//   sampler s;         // s0            =>  sampler s;     // s0
//   tex2D(s, uv) + t.Sample(s, uv)          sampler2D s;   // t0
//
// Reports SamplerKinds where a sampler is read as textures of several kinds, but for elements of an
// array up to shader model 3, and as one and two dimensions in a later one. Where it seems to be
// so, the reads count that DropDeadReads leaves. Requires ResolveObjects.
void SettleSamplers(Program& program, Diagnostics& diagnostics);

}  // namespace clipc::resolve
