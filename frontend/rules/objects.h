// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "frontend/rules/conversion.h"

// What a shader may do with a texture, a sampler or a buffer, and what it means in IR. After an
// error was reported, the result has the error type.
namespace clipc::rules {

// object.method(arguments). GetDimensions becomes assignments to its arguments, joined by Commas.
ExprId CheckMethodCall(Program& program, ExprId object, std::string_view method, Span method_span,
                       std::span<const ExprId> arguments, Span call_span,
                       TemporaryMaker& temporaries, Diagnostics& diagnostics);

// object[index]; object.mips[level][index] and object.sample[level][index] when `level` is given.
ExprId CheckObjectIndex(Program& program, ExprId object, ExprId index, std::optional<ExprId> level,
                        Span span, Diagnostics& diagnostics);

}  // namespace clipc::rules
