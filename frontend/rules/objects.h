// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "frontend/rules/conversion.h"
#include "ir/program.h"

// What a shader may do with a texture, a sampler or a buffer, and what it means in IR. After an
// error was reported, the result has the error type.
namespace clipc {

// object.method(arguments). GetDimensions becomes assignments to its arguments, joined by Commas.
ir::ExprId CheckMethodCall(ir::Program& program, ir::ExprId object, std::string_view method,
                           Span method_span, std::span<const ir::ExprId> arguments, Span call_span,
                           TemporaryMaker& temporaries, Diagnostics& diagnostics);

// object[index]; object.mips[level][index] and object.sample[level][index] when `level` is given.
ir::ExprId CheckObjectIndex(ir::Program& program, ir::ExprId object, ir::ExprId index,
                            std::optional<ir::ExprId> level, Span span, Diagnostics& diagnostics);

}  // namespace clipc
