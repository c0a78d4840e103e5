// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "frontend/typing/conversion.h"
#include "ir/builder.h"

// The state of one call of a function or method that HLSL has built in, while it is checked.
namespace clipc::typing {

struct IntrinsicCheck {
  Program& program;
  std::string_view name;
  Span name_span;
  std::span<const ExprId> arguments;
  Span call_span;
  TemporaryMaker& temporaries;
  Diagnostics& diagnostics;

  const StageInfo& ThisStage() const { return clipc::InfoOf(program.stage); }
  Builder Make() const { return Builder(program, call_span); }
  ExprId Error() const { return Make().ZeroOf(program.types.Error()); }
  // Reports, and returns an expression of the error type.
  template <typename... Args>
  ExprId Fail(Span where, const diag::Kind<Args...>& kind,
              const std::type_identity_t<Args>&... args) const {
    diagnostics.Report(where, kind, args...);
    return Error();
  }
  TypeId TypeIdOf(ExprId expr) const { return program.exprs[expr].type; }
  const Type& TypeOf(ExprId expr) const { return program.types[TypeIdOf(expr)]; }
  TypeId ArgumentTypeId(std::size_t i) const { return TypeIdOf(arguments[i]); }
  const Type& ArgumentType(std::size_t i) const { return TypeOf(arguments[i]); }
  Span SpanOf(ExprId expr) const { return program.exprs[expr].span; }

  // Whether an argument has the error type; that error was reported.
  bool HasErrorArgument() const {
    return std::ranges::any_of(
        arguments, [&](ExprId argument) { return TypeIdOf(argument) == program.types.Error(); });
  }
  // Reports and returns false unless the number of arguments is from `least` to `most`.
  bool HasCount(std::size_t least, std::size_t most) const;
  // Reports that an argument has a type that does not fit; `expected` completes "it must be ...".
  ExprId BadArgument(std::size_t i, std::string_view expected) const;
  // Returns the argument converted to `type`; reports and returns nullopt if it does not convert.
  std::optional<ExprId> Converted(std::size_t i, TypeId type) const;
  ExprId Convert(ExprId value, TypeId type) const {
    return ConvertImplicit(program, value, type, diagnostics, &temporaries);
  }
  ExprId ConvertArgument(std::size_t i, TypeId type) const { return Convert(arguments[i], type); }
  // The type of a vector of `count` components; a scalar, not a vector of one, if count is 1.
  TypeId VectorOf(Scalar kind, int count) const {
    return count == 1 ? program.types.Make(kind) : program.types.Vector(kind, count);
  }

  // Reports and returns false unless the argument can be assigned to. An index into a swizzle
  // becomes an index into the vector.
  bool IsTarget(std::size_t i) const;
  // Reports and returns false unless the argument can be assigned to and `type` converts to its
  // type.
  bool IsTargetOf(std::size_t i, TypeId type) const;

  // The leading `count` components of a vector and its component `last`, to be evaluated after
  // `prologue`, if there is one.
  struct Parts {
    ExprId leading, last, prologue;
  };
  Parts Split(ExprId vector, int count, int last) const;
};

// The expression that evaluates `steps`, any of which may be none, and then is `value`.
ExprId After(const IntrinsicCheck& call, std::span<const ExprId> steps, ExprId value);

// intrinsics_signature.cpp
ExprId CheckBySignature(const IntrinsicCheck& call, Intrinsic op);
// Whether the arguments fit the signature, which has no `out`; reports nothing.
bool FitsSignature(const IntrinsicCheck& call, Intrinsic op);
// An argument that an intrinsic writes.
struct OutArgument {
  ExprId target;  // the argument as the user wrote it
  TypeId type;    // the type that the intrinsic writes
};
// A call with the arguments `ins` and then `outs`. A target of another type than the intrinsic
// writes gets its value from a temporary after the call.
ExprId CallWithOuts(const IntrinsicCheck& call, Intrinsic op, TypeId result,
                    std::span<const ExprId> ins, std::span<const OutArgument> outs);

// intrinsics_special.cpp
ExprId CheckMul(const IntrinsicCheck& call);
ExprId CheckBitCast(const IntrinsicCheck& call, Intrinsic op);
// Checks countbits, reversebits, firstbithigh or firstbitlow of integers of 64 bits, which become
// calls for their halves; none of others.
ExprId CheckWideBits(const IntrinsicCheck& call, Intrinsic op);
ExprId CheckSelect(const IntrinsicCheck& call);
ExprId CheckLogical(const IntrinsicCheck& call, BinaryOp op);

// stand_in.cpp
// The type of a value that stands for a call.
enum class StandIn : std::uint8_t {
  kVoid,   // an int that nobody uses
  kFirst,  // the type of the first argument
  kBool,
  kUint,
  kUint4,
  kFloat,
  kFloat2,
  kFloat4,
};
// The stages that may call a function or method which clipc does not translate.
struct Staged {
  bool StageInfo::* trait = nullptr;  // those that have it; null: no stage
  StandIn type = StandIn::kVoid;
};
// A value that stands for the call in a shader that is read for its interface only; otherwise, and
// in a stage without the trait, none.
ExprId StandInFor(const IntrinsicCheck& call, const Staged& staged);

// atomic_call.cpp: checks InterlockedAdd and its kin, or the methods of an RWByteAddressBuffer,
// `object`, of that name.
ExprId CheckAtomic(const IntrinsicCheck& call, ExprId object = {});
// invocation_call.cpp: checks IsHelperLane() and its kin, which are inputs of the shader.
ExprId CheckFact(const IntrinsicCheck& call);
ExprId CheckFirstLane(const IntrinsicCheck& call);
// Checks GetRenderTargetSamplePosition(sample).
ExprId CheckTargetSamplePosition(const IntrinsicCheck& call);
// Checks the place of the call's sample, one of `count`, in a pixel.
ExprId CheckSamplePosition(const IntrinsicCheck& call, ExprId count);
// direct3d9_call.cpp: checks tex2Dlod, tex2D and the like.
ExprId CheckTexLod(const IntrinsicCheck& call);
ExprId CheckTex(const IntrinsicCheck& call);
ExprId CheckTexBias(const IntrinsicCheck& call);
ExprId CheckTexGrad(const IntrinsicCheck& call);
ExprId CheckTexProj(const IntrinsicCheck& call);

}  // namespace clipc::typing
