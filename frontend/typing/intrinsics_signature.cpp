// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/invariant.h"
#include "frontend/typing/intrinsic_call.h"
#include "ir/access.h"

// The check of calls against the signatures of ir/intrinsics.def. Arguments unify as DXC's
// MatchArguments does: the smallest vector wins, scalars are splatted, kinds combine, and a kind
// that the intrinsic lacks becomes float. Matrices unify as fxc's do: the part that all have is
// what counts.
namespace clipc::typing {
namespace {

constexpr const char* ShapeText(char shape) {
  switch (shape) {
    case 'v': return "a scalar or a vector";
    case 's': return "a scalar";
    case '2': return "a vector of two";
    case '3': return "a vector of three";
    case '4': return "a vector of four";
    case 'm':
    case 'q': return "a scalar or a matrix";
    default: return "a scalar, vector or matrix";
  }
}

// The kinds and the shape that the arguments of one call agree on.
class Unifier : IntrinsicCheck {
 public:
  Unifier(const IntrinsicCheck& call, const IntrinsicSignature& signature)
      : IntrinsicCheck(call), signature_(signature) {}

  // Unifies the arguments. Returns false after an error, which was reported.
  bool Run() {
    for (std::size_t i = 0; i < signature_.count; ++i) {
      if (!signature_.arguments[i].is_out && !Take(i)) return false;
    }
    for (std::size_t i = 0; i < signature_.count; ++i) {
      if (signature_.arguments[i].kind == 'd' && kind_ != Scalar::kDouble) {
        BadArgument(i, "a double, or a vector or matrix of doubles");
        return false;
      }
    }
    return true;
  }

  TypeId TypeOf(IntrinsicSlot slot) const {
    TypeTable& types = program.types;
    const Scalar kind = KindOf(slot.kind);
    switch (slot.shape) {
      case 'g': return types.WithScalar(common_, kind);
      case 'v': return VectorOf(kind, vector_size_);
      case 's': return types.Make(kind);
      case '2':
      case '3':
      case '4': return types.Vector(kind, slot.shape - '0');
      case 'm': return types.Matrix(kind, rows_, columns_);
      case 't': return types.Matrix(kind, columns_, rows_);
      case 'q': return types.Matrix(kind, std::min(rows_, columns_), std::min(rows_, columns_));
      default: return types.Void();
    }
  }

 private:
  bool Take(std::size_t i) {
    const IntrinsicSlot slot = signature_.arguments[i];
    const Type& type = ArgumentType(i);
    if (!type.IsNumeric() || !TakeShape(i, slot.shape, type)) {
      BadArgument(i, ShapeText(slot.shape));
      return false;
    }
    if (std::string_view("frnawd").find(slot.kind) != std::string_view::npos) {
      kind_ = kind_ ? CommonKind(*kind_, type.scalar) : type.scalar;
    }
    return true;
  }

  bool TakeShape(std::size_t i, char shape, const Type& type) {
    const bool is_single = type.Components() == 1;
    switch (shape) {
      case 'g': {
        const TypeId id = ArgumentTypeId(i);
        const auto common = common_ ? CommonShape(common_, id) : id;
        if (common) common_ = *common;
        return common.has_value();
      }
      case 'v':
        if (is_single) return true;
        if (type.kind != TypeKind::kVector) return false;
        vector_size_ = vector_size_ == 1 ? type.columns : std::min<int>(vector_size_, type.columns);
        return true;
      case '2':
      case '3':
      case '4': return is_single || (type.kind == TypeKind::kVector && type.columns >= shape - '0');
      case 'm':
      case 'q':
        rows_ = type.rows;
        columns_ = type.columns;
        return type.kind == TypeKind::kMatrix || type.kind == TypeKind::kScalar;
      default: return true;  // a scalar: anything truncates to it
    }
  }

  // The type that CommonType gives, and float2x2 for float2x3 and float3x2, which no operator takes
  // together.
  std::optional<TypeId> CommonShape(TypeId left_id, TypeId right_id) const {
    if (const auto common = CommonType(program.types, left_id, right_id)) return common;
    const Type left = program.types[left_id];
    const Type right = program.types[right_id];
    if (left.kind != TypeKind::kMatrix || right.kind != TypeKind::kMatrix) return std::nullopt;
    return program.types.Matrix(left.scalar, std::min(left.rows, right.rows),
                                std::min(left.columns, right.columns));
  }

  Scalar KindOf(char letter) const {
    const Scalar kind = kind_.value_or(Scalar::kFloat);
    switch (letter) {
      case 'f': return IsFloat(kind) && kind != Scalar::kDouble ? kind : Scalar::kFloat;
      case 'r': return IsFloat(kind) ? kind : Scalar::kFloat;
      case 'n': return kind == Scalar::kBool ? Scalar::kFloat : kind;
      case 'b': return Scalar::kBool;
      case 'w': return IsUnsigned(kind) ? Scalar::kUint : Scalar::kInt;
      case 'i': return Scalar::kInt;
      case 'u': return Scalar::kUint;
      case 'd': return Scalar::kDouble;
      default: return kind;
    }
  }

  const IntrinsicSignature& signature_;
  std::optional<Scalar> kind_;
  TypeId common_;
  int vector_size_ = 1;
  int rows_ = 1;
  int columns_ = 1;
};

}  // namespace

ExprId CheckBySignature(const IntrinsicCheck& call, Intrinsic op) {
  const IntrinsicSignature& signature = InfoOf(op).signature;
  if (!call.HasCount(signature.count, signature.count)) return call.Error();
  Unifier unifier(call, signature);
  if (!unifier.Run()) return call.Error();

  std::array<ExprId, IntrinsicSignature::kMaxArguments> ins;
  std::size_t count = 0;
  std::vector<OutArgument> outs;
  for (std::size_t i = 0; i < signature.count; ++i) {
    const IntrinsicSlot slot = signature.arguments[i];
    const TypeId type = unifier.TypeOf(slot);
    if (!slot.is_out) {
      ins[count++] = call.ConvertArgument(i, type);
      continue;
    }
    if (!call.IsTargetOf(i, type)) return call.Error();
    outs.push_back({call.arguments[i], type});
  }
  return CallWithOuts(call, op, unifier.TypeOf(signature.result), std::span(ins).first(count),
                      outs);
}

bool FitsSignature(const IntrinsicCheck& call, Intrinsic op) {
  const IntrinsicSignature& signature = InfoOf(op).signature;
  if (signature.is_special || signature.count != call.arguments.size()) return false;
  for (std::size_t i = 0; i < signature.count; ++i) {
    if (signature.arguments[i].is_out) return false;
  }
  Diagnostics unused;
  const IntrinsicCheck trial{call.program,   call.name,        call.name_span, call.arguments,
                             call.call_span, call.temporaries, unused};
  return Unifier(trial, signature).Run();
}

ExprId CallWithOuts(const IntrinsicCheck& call, Intrinsic op, TypeId result,
                    std::span<const ExprId> ins, std::span<const OutArgument> outs) {
  Builder builder = call.Make();
  if (outs.empty()) return builder.Add(result, IntrinsicCall{op, call.program.expr_lists.Add(ins)});
  std::vector<ExprId> arguments(ins.begin(), ins.end());
  std::vector<ExprId> before;
  std::vector<ExprId> after;
  for (const OutArgument& out : outs) {
    const TypeId target_type = call.TypeIdOf(out.target);
    const auto* matrix = As<MatrixSwizzle>(call.program, out.target);
    if (target_type == out.type && !matrix) {
      arguments.push_back(out.target);
      continue;
    }
    const auto temporary = call.temporaries.Make(builder.ZeroOf(out.type));
    before.push_back(temporary.prologue);
    arguments.push_back(builder.Ref(temporary.var));
    Builder at_target(call.program, call.SpanOf(out.target));
    if (!matrix) {
      const ExprId value = call.Convert(at_target.Ref(temporary.var), target_type);
      after.push_back(builder.AssignTo(out.target, value));
      continue;
    }
    // m._m00_m11 is written component by component.
    const MatrixSwizzle places = *matrix;
    const TypeId component = call.program.types.Make(call.TypeOf(out.target).scalar);
    for (int i = 0; i < places.count; ++i) {
      const ExprId row = builder.At(Clone(call.program, places.base), places.rows[i]);
      const ExprId value = at_target.Swizzled(at_target.Ref(temporary.var), {i});
      after.push_back(
          builder.AssignTo(builder.At(row, places.columns[i]), call.Convert(value, component)));
    }
  }
  const auto list = call.program.expr_lists.Add(arguments);
  ExprId value = builder.Add(result, IntrinsicCall{op, list});
  if (!after.empty() && result != call.program.types.Void()) {
    const auto held = call.temporaries.Make(value);
    after.insert(after.begin(), held.prologue);
    value = After(call, after, builder.Ref(held.var));
  } else {
    for (const ExprId each : after) value = builder.CommaOf(value, each);
  }
  return After(call, before, value);
}

}  // namespace clipc::typing
