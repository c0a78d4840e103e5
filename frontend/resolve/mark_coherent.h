// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/resolve/names.h"

namespace clipc::resolve {

// Makes the writable textures and buffers coherent through which the threads of a group exchange
// values: those that a shader both reads and writes, if it has a barrier that orders accesses to
// them.
//
//   RWBuffer<uint> b;                    =>   globallycoherent RWBuffer<uint> b;
//   b[i] = i;                                 b[i] = i;
//   DeviceMemoryBarrierWithGroupSync();       DeviceMemoryBarrierWithGroupSync();
//   o[i] = b[63 - i];                         o[i] = b[63 - i];
//
// A barrier of Direct3D makes them coherent in the group. In GLSL and SPIR-V a barrier orders what
// is declared coherent only ("Memory qualifiers" in the specification of GLSL 4.60). An object that
// atomic operations alone access is coherent without a word.
void MarkCoherent(Program& program);

}  // namespace clipc::resolve
