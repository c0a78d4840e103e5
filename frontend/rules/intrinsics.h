// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "frontend/rules/conversion.h"
#include "ir/program.h"

// The functions and methods that HLSL has built in: which there are, what they take, and what a
// call means in IR.
namespace clipc {

// Whether `name` is a function HLSL has built in for any stage ("ddx" too).
bool IsIntrinsicName(std::string_view name);

// A call name(arguments) of a built-in function as IR, arguments converted, with diagnostics for a
// wrong number or types of arguments (X3013, X3014), for functions that no vertex shader may call
// (ddx, clip, tex2D without level, wave and atomic operations: each its own message) and for those
// the profile lacks. Handles the ones that are not IR intrinsics of their own too: select, and, or,
// tex2Dlod and friends, NonUniformResourceIndex, mul of all nine forms, asuint(double, out, out),
// dot on ints. Returns an expression of the error type after reporting an error.
ir::ExprId CheckIntrinsicCall(ir::Program& program, std::string_view name, Span name_span,
                              std::span<const ir::ExprId> arguments, Span call_span,
                              TemporaryMaker& temporaries, Diagnostics& diagnostics);

// object.method(arguments) on texture, sampler and buffer objects. GetDimensions becomes
// assignments (Comma) of kTextureSize components.
ir::ExprId CheckMethodCall(ir::Program& program, ir::ExprId object, std::string_view method,
                           Span method_span, std::span<const ir::ExprId> arguments, Span call_span,
                           TemporaryMaker& temporaries, Diagnostics& diagnostics);
// object[index], and object.mips[level][index] with `level` given.
ir::ExprId CheckObjectIndex(ir::Program& program, ir::ExprId object, ir::ExprId index,
                            std::optional<ir::ExprId> level, Span span, Diagnostics& diagnostics);

// The names like `name` among the built-in functions, nearest first, for "did you mean".
std::vector<std::string_view> NearIntrinsics(std::string_view name);

}  // namespace clipc
