// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/typing/intrinsic_call.h"

// The operations on a texture, a sampler or a buffer, and the IR that they mean. After an error was
// reported, the result has the error type.
namespace clipc::typing {

// Returns the call of a method of the object as IR. GetDimensions becomes assignments to its
// arguments, joined by Commas.
ExprId CheckMethodCall(const IntrinsicCheck& call, ExprId object);

// Returns object.Length as IR, a uint or a vector of uints: the size of level 0 with the number of
// elements of an array, or the elements of a buffer. fxc has it from 4.0 on, but not of cubes
// (vkd3d's length-property.shader_test, checked against native), dxc has not; none without it.
ExprId CheckLength(Program& program, ExprId object, Span span);

// object[index], or object.mips[level][index] or object.sample[level][index] if `level` is given.
struct ObjectIndex {
  ExprId object, index;
  std::optional<ExprId> level = {};
  Span span = {};
};
// Returns the element as IR.
ExprId CheckObjectIndex(Program& program, const ObjectIndex& of, Diagnostics& diagnostics);

}  // namespace clipc::typing
