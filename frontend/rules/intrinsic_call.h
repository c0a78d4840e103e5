// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "frontend/rules/conversion.h"
#include "ir/builder.h"
#include "ir/program.h"

// One call of a function or method that HLSL has built in, while it is checked.
namespace clipc {

class IntrinsicCheck {
 public:
  IntrinsicCheck(ir::Program& program, std::string_view name, Span name_span,
                 std::span<const ir::ExprId> arguments, Span call_span, TemporaryMaker& temporaries,
                 Diagnostics& diagnostics)
      : program(program),
        name(name),
        name_span(name_span),
        arguments(arguments),
        call_span(call_span),
        temporaries(temporaries),
        diagnostics(diagnostics) {}

  ir::Program& program;
  std::string_view name;
  Span name_span;
  std::span<const ir::ExprId> arguments;
  Span call_span;
  TemporaryMaker& temporaries;
  Diagnostics& diagnostics;

  ir::Builder Make() const { return ir::Builder(program, call_span); }
  ir::ExprId Error() const { return Make().ZeroOf(program.types.Error()); }
  ir::TypeId TypeIdOf(ir::ExprId expr) const { return program.exprs[expr].type; }
  const ir::Type& TypeOf(ir::ExprId expr) const { return program.types[TypeIdOf(expr)]; }
  const ir::Type& ArgumentType(std::size_t i) const { return TypeOf(arguments[i]); }
  Span SpanOf(ir::ExprId expr) const { return program.exprs[expr].span; }

  // False, and reported, when the number of arguments is not between these.
  bool HasCount(std::size_t least, std::size_t most) const;
  // Reports that an argument has a type that does not fit; `expected` completes "it must be ...".
  ir::ExprId BadArgument(std::size_t i, std::string_view expected) const;
  // Reports unless the argument converts to `type`.
  std::optional<ir::ExprId> Converted(std::size_t i, ir::TypeId type) const;
  ir::ExprId Convert(ir::ExprId value, ir::TypeId type) const {
    return ConvertImplicit(program, value, type, diagnostics, &temporaries);
  }
  // A scalar, not a vector of one, when count is 1.
  ir::TypeId VectorOf(ir::Scalar kind, int count) const {
    return count == 1 ? program.types.Make(kind) : program.types.Vector(kind, count);
  }

  // Reports unless the argument can be assigned to.
  bool IsTarget(std::size_t i) const;

  // The leading `count` components of a vector and its component `last`, to be evaluated after
  // `prologue`, if there is one.
  struct Parts {
    ir::ExprId leading, last, prologue;
  };
  Parts Split(ir::ExprId vector, int count, int last) const;
};

// `value` after `steps`, any of which may be none.
ir::ExprId After(const IntrinsicCheck& call, std::span<const ir::ExprId> steps, ir::ExprId value);

// intrinsics_signature.cpp
ir::ExprId CheckBySignature(const IntrinsicCheck& call, ir::Intrinsic op);
// An argument that an intrinsic writes.
struct OutArgument {
  ir::ExprId target;  // as the user wrote it
  ir::TypeId type;    // that the intrinsic writes
};
// A call with the arguments `ins` and then `outs`. A target of another type than the intrinsic
// writes gets its value from a temporary after the call.
ir::ExprId CallWithOuts(const IntrinsicCheck& call, ir::Intrinsic op, ir::TypeId result,
                        std::span<const ir::ExprId> ins, std::span<const OutArgument> outs);

// intrinsics_special.cpp
ir::ExprId CheckMul(const IntrinsicCheck& call);
ir::ExprId CheckBitCast(const IntrinsicCheck& call, ir::Intrinsic op);
ir::ExprId CheckSelect(const IntrinsicCheck& call);
ir::ExprId CheckLogical(const IntrinsicCheck& call, ir::BinaryOp op);
// tex2Dlod and its family.
ir::ExprId CheckTexLod(const IntrinsicCheck& call);

}  // namespace clipc
