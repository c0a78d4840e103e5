// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "frontend/signature/names.h"
#include "ir/builder.h"

// Values of a pixel shader's inputs that GLSL has in another form.
namespace clipc::signature {

// The position of a sample with the x and y of the center of its pixel.
ExprId CenterOf(Program& program, ExprId position);
// The first `count` components of the position as Direct3D 9 has it: whole numbers, where those of
// later versions have a half, the pixel's center.
ExprId CornerOf(Builder builder, ExprId position, std::uint32_t count);
// The position, computed so that the sample's number is read: 0 is added, since a number is less
// than 32.
ExprId AfterSampleNumber(Builder builder, ExprId position, ExprId number);
// Whether a face is the front one: as a bool; as the bits of an integer, which are all set or all
// clear; as the sign of a float.
ExprId FacingOf(Builder builder, ExprId is_front, Scalar kind);
// Whether the first bit of `coverage` is set, which `bool c : SV_Coverage` is in fxc's code: it
// masks the coverage with 1.
ExprId FirstBitOf(Program& program, ExprId coverage);

}  // namespace clipc::signature
