// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <array>
#include <vector>

#include "frontend/typing/intrinsic_call.h"
#include "frontend/typing/reread.h"
#include "ir/access.h"
#include "ir/intrinsic_list.h"

namespace clipc::typing {
namespace {

// ---- mul

ExprId MulScalar(const IntrinsicCheck& call, TypeId type) {
  const ExprId left = call.ConvertArgument(0, type);
  const ExprId right = call.ConvertArgument(1, type);
  return call.Make().BinaryOf(BinaryOp::kMul, left, right);
}

// The product of a vector of one and a matrix, in either order: its one component times the first
// row or column.
ExprId MulSingle(const IntrinsicCheck& call, bool vector_first, Scalar kind) {
  const Type matrix = call.ArgumentType(vector_first ? 1 : 0);
  const int size = vector_first ? matrix.columns : matrix.rows;
  const TypeId line = vector_first ? call.program.types.Matrix(kind, 1, size)
                                   : call.program.types.Matrix(kind, size, 1);
  const TypeId type = call.VectorOf(kind, size);
  const auto convert = [&](std::size_t i, bool is_matrix) {
    return call.Convert(is_matrix ? call.ConvertArgument(i, line) : call.arguments[i], type);
  };
  const ExprId left = convert(0, !vector_first);
  return call.Make().BinaryOf(BinaryOp::kMul, left, convert(1, vector_first));
}

// The argument as a tensor of that type. A matrix that loses a row or column to a shorter vector,
// as in mul(float3, float4x4), gets a note that says what that may be.
ExprId MulTensor(const IntrinsicCheck& call, std::size_t i, TypeId to) {
  const Type& type = call.ArgumentType(i);
  const Type& other = call.ArgumentType(1 - i);
  const bool loses = type.kind == TypeKind::kMatrix && other.kind == TypeKind::kVector &&
                     other.columns == 3 && (i == 1 ? type.rows : type.columns) == 4;
  if (!loses) return call.ConvertArgument(i, to);
  const ExprId argument = call.arguments[i];
  const TypeTable& types = call.program.types;
  call.diagnostics
      .Report(call.SpanOf(argument), diag::ImplicitTruncation, types.Name(call.ArgumentTypeId(i)),
              types.Name(to))
      .Note(call.SpanOf(call.arguments[1 - i]), diag::MulLosesTranslation,
            i == 1 ? "row" : "column");
  return ConvertExplicit(call.program, argument, to, call.temporaries);
}

ExprId MulTensors(const IntrinsicCheck& call, Scalar kind) {
  TypeTable& types = call.program.types;
  const Type a = call.ArgumentType(0);
  const Type b = call.ArgumentType(1);
  const bool a_is_vector = a.kind == TypeKind::kVector;
  const bool b_is_vector = b.kind == TypeKind::kVector;
  // The sides that are summed over become equally long: mul(float3, float4x4) uses three rows
  // (X3206, fxc and DXC).
  const int inner = std::min(a.columns, b_is_vector ? b.columns : b.rows);
  if (inner == 1 && a_is_vector != b_is_vector && (a_is_vector ? a : b).columns == 1)
    return MulSingle(call, a_is_vector, kind);
  if (a_is_vector && b_is_vector) {
    const TypeId type = call.VectorOf(kind, inner);
    const ExprId left = call.ConvertArgument(0, type);
    const ExprId right = call.ConvertArgument(1, type);
    if (inner == 1) return call.Make().BinaryOf(BinaryOp::kMul, left, right);
    return call.Make().IntrinsicOf(Intrinsic::kDot, types.Make(kind), {left, right});
  }
  const TypeId left_type =
      a_is_vector ? types.Vector(kind, inner) : types.Matrix(kind, a.rows, inner);
  const TypeId right_type =
      b_is_vector ? types.Vector(kind, inner) : types.Matrix(kind, inner, b.columns);
  const TypeId result = a_is_vector   ? types.Vector(kind, b.columns)
                        : b_is_vector ? types.Vector(kind, a.rows)
                                      : types.Matrix(kind, a.rows, b.columns);
  const ExprId left = MulTensor(call, 0, left_type);
  const ExprId right = MulTensor(call, 1, right_type);
  return call.Make().IntrinsicOf(Intrinsic::kMul, result, {left, right});
}

// ---- bits

// The call asuint(double, out low, out high).
ExprId SplitDouble(const IntrinsicCheck& call) {
  const Type& type = call.ArgumentType(0);
  if (!type.IsNumeric()) return call.BadArgument(0, "a double");
  TypeTable& types = call.program.types;
  const TypeId whole = types.WithScalar(call.ArgumentTypeId(0), Scalar::kDouble);
  const TypeId half = types.WithScalar(whole, Scalar::kUint);
  for (const std::size_t i : {1u, 2u}) {
    if (!call.IsTargetOf(i, half)) return call.Error();
  }
  const std::array<ExprId, 1> ins = {call.ConvertArgument(0, whole)};
  const std::array<OutArgument, 2> outs = {OutArgument{call.arguments[1], half},
                                           OutArgument{call.arguments[2], half}};
  return CallWithOuts(call, Intrinsic::kAsUint, types.Void(), ins, outs);
}

}  // namespace

ExprId CheckMul(const IntrinsicCheck& call) {
  if (!call.HasCount(2, 2)) return call.Error();
  for (std::size_t i = 0; i < 2; ++i) {
    if (!call.ArgumentType(i).IsNumeric()) return call.BadArgument(i, "a scalar, vector or matrix");
  }
  const Type& a = call.ArgumentType(0);
  const Type& b = call.ArgumentType(1);
  Scalar kind = CommonKind(a.scalar, b.scalar);
  if (kind == Scalar::kBool) kind = Scalar::kFloat;
  if (a.kind == TypeKind::kScalar || b.kind == TypeKind::kScalar) {
    const ExprId shaped = call.arguments[a.kind == TypeKind::kScalar ? 1 : 0];
    return MulScalar(call, call.program.types.WithScalar(call.TypeIdOf(shaped), kind));
  }
  return MulTensors(call, kind);
}

ExprId CheckBitCast(const IntrinsicCheck& call, Intrinsic op) {
  const bool to_uint = op == Intrinsic::kAsUint;
  if (!call.HasCount(1, to_uint && call.arguments.size() > 1 ? 3 : 1)) return call.Error();
  if (call.arguments.size() == 3) return SplitDouble(call);
  if (call.arguments.size() == 2) return call.HasCount(3, 3), call.Error();
  const Type& type = call.ArgumentType(0);
  if (!type.IsNumeric() || IsWide(type.scalar) || type.scalar == Scalar::kBool) {
    return call.BadArgument(0, "a float, int or uint, or a vector or matrix of them");
  }
  TypeTable& types = call.program.types;
  const Scalar base = BaseOf(type.scalar);
  const Scalar target = to_uint                   ? Scalar::kUint
                        : op == Intrinsic::kAsInt ? Scalar::kInt
                                                  : Scalar::kFloat;
  const ExprId value = call.ConvertArgument(0, types.WithScalar(call.ArgumentTypeId(0), base));
  const TypeId result = types.WithScalar(call.TypeIdOf(value), target);
  // Between int and uint a conversion keeps the bits.
  if (base == target || (base != Scalar::kFloat && target != Scalar::kFloat))
    return call.Convert(value, result);
  return call.Make().IntrinsicOf(op, result, {value});
}

ExprId CheckLogical(const IntrinsicCheck& call, BinaryOp op) {
  if (!call.HasCount(2, 2)) return call.Error();
  TypeTable& types = call.program.types;
  const auto common = CommonType(types, call.ArgumentTypeId(0), call.ArgumentTypeId(1));
  if (!common || !types[*common].IsNumeric())
    return call.BadArgument(1, "a bool of the shape of the first");
  const TypeId type = types.WithScalar(*common, Scalar::kBool);
  const ExprId left = call.ConvertArgument(0, type);
  return call.Make().BinaryOf(op, left, call.ConvertArgument(1, type));
}

// Checks select(condition, a, b): both are evaluated, and each component is chosen by that of the
// condition.
ExprId CheckSelect(const IntrinsicCheck& call) {
  if (!call.HasCount(3, 3)) return call.Error();
  TypeTable& types = call.program.types;
  if (!call.ArgumentType(0).IsNumeric())
    return call.BadArgument(0, "a bool, or a vector or matrix of them");
  const TypeId condition_type = types.WithScalar(call.ArgumentTypeId(0), Scalar::kBool);
  const auto common = CommonType(types, call.ArgumentTypeId(1), call.ArgumentTypeId(2));
  if (!common) return call.BadArgument(2, "of the type of the second");
  Builder builder = call.Make();
  if (types[condition_type].Components() > 1) {
    const auto shape = CommonType(types, condition_type, types.WithScalar(*common, Scalar::kBool));
    if (!types[*common].IsNumeric() || !shape)
      return call.BadArgument(1, "of the shape of the condition");
    const TypeId type = types.WithScalar(*shape, types[*common].scalar);
    const ExprId condition = call.ConvertArgument(0, *shape);
    const ExprId when_true = call.ConvertArgument(1, type);
    return builder.Add(type, Select{condition, when_true, call.ConvertArgument(2, type)});
  }
  ExprId condition = call.ConvertArgument(0, types.Make(Scalar::kBool));
  ExprId when_true = call.ConvertArgument(1, *common);
  ExprId when_false = call.ConvertArgument(2, *common);
  std::vector<ExprId> before;
  if (!MayBeSkipped(call.program, when_true) || !MayBeSkipped(call.program, when_false)) {
    for (ExprId* each : {&condition, &when_true, &when_false}) {
      const auto temporary = call.temporaries.Make(*each);
      before.push_back(temporary.prologue);
      *each = builder.Ref(temporary.var);
    }
  }
  return After(call, before, builder.Add(*common, Conditional{condition, when_true, when_false}));
}

ExprId CheckWideBits(const IntrinsicCheck& call, Intrinsic op) {
  if (call.arguments.size() != 1 || !call.ArgumentType(0).IsNumeric()) return {};
  const Scalar kind = call.ArgumentType(0).scalar;
  if (kind != Scalar::kInt64 && kind != Scalar::kUint64) return {};
  TypeTable& types = call.program.types;
  Builder at = call.Make();
  const auto held = call.temporaries.Make(call.arguments[0]);
  const TypeId wide = call.ArgumentTypeId(0), words = types.WithScalar(wide, Scalar::kUint);
  const auto value = [&] { return at.Ref(held.var); };
  const auto splat = [&](TypeId type, std::uint64_t bits) {
    return at.SplatTo(type, at.Add(types.Make(types[type].scalar), Literal{bits}));
  };
  // The first bit of a number below 0 is the first that is not set.
  const bool is_signed = op == Intrinsic::kFirstBitHigh && kind == Scalar::kInt64;
  const auto word = [&](bool is_high) {
    ExprId bits = value();
    if (is_high) bits = at.BinaryOf(BinaryOp::kShiftRight, bits, splat(wide, 32));
    bits = at.ConvertTo(Scalar::kUint, bits);
    if (!is_signed) return bits;
    const ExprId sign =
        at.ConvertTo(Scalar::kUint, at.BinaryOf(BinaryOp::kShiftRight, value(), splat(wide, 63)));
    return at.BinaryOf(BinaryOp::kBitXor, bits, sign);
  };
  const auto low = call.temporaries.Make(word(false)), high = call.temporaries.Make(word(true));
  const auto of = [&](VarId var) { return at.IntrinsicOf(op, words, {at.Ref(var)}); };
  ExprId result;
  if (op == Intrinsic::kCountBits) {
    result = at.BinaryOf(BinaryOp::kAdd, of(low.var), of(high.var));
  } else if (op == Intrinsic::kReverseBits) {
    const TypeId bits = types.WithScalar(wide, Scalar::kUint64);
    result = at.BinaryOf(BinaryOp::kShiftLeft, at.ConvertTo(Scalar::kUint64, of(low.var)),
                         splat(bits, 32));
    result = at.BinaryOf(BinaryOp::kBitOr, result, at.ConvertTo(Scalar::kUint64, of(high.var)));
  } else {
    // The word with the first bit, and the other, where the first word has none.
    const bool from_high = op == Intrinsic::kFirstBitHigh;
    const ExprId in_high = at.BinaryOf(BinaryOp::kBitOr, of(high.var), splat(words, 32));
    const ExprId first = from_high ? in_high : of(low.var);
    const ExprId other = from_high ? of(low.var) : in_high;
    const ExprId is_set =
        at.BinaryOf(BinaryOp::kNotEqual, at.Ref(from_high ? high.var : low.var), splat(words, 0));
    result = types[words].kind == TypeKind::kScalar
                 ? at.Add(words, Conditional{is_set, first, other})
                 : at.Add(words, Select{is_set, first, other});
  }
  return After(call, std::array{held.prologue, low.prologue, high.prologue}, result);
}

}  // namespace clipc::typing
