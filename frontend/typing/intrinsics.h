// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>
#include <vector>

#include "frontend/typing/intrinsic_call.h"

// The functions that HLSL has built in: their names, their arguments, and the IR that a call means.
// Their rows are in ir/intrinsics.def.
namespace clipc::typing {

// Whether `name` is a function that HLSL has built in for any stage: "ddx" too.
bool IsIntrinsicName(std::string_view name);
// Whether `name` is a built-in function that clipc translates and that writes an argument:
// modf, sincos.
bool IsWritingIntrinsic(std::string_view name);

// Returns the call of a built-in function as IR, its arguments converted. Reports a
// wrong number or type of arguments (X3013, X3014), a function that the stage may not call (ddx,
// clip, tex2D without a level, ...), and one that the profile does not have; the result then has
// the error type. Many functions become other nodes than an IntrinsicCall: select, and, or,
// tex2Dlod, mul with a scalar, asint of integers.
ExprId CheckIntrinsicCall(const IntrinsicCheck& call);

// Whether the call's arguments fit the signature of an intrinsic that writes none of them.
bool TakesArguments(const IntrinsicCheck& call);

// The names like `name` among the functions that clipc translates, nearest first, for "did you
// mean".
std::vector<std::string_view> NearIntrinsics(std::string_view name);

}  // namespace clipc::typing
