// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <array>
#include <utility>

#include "ir/intrinsic_list.h"
#include "ir/verifier.h"

namespace clipc::ir {
namespace {

bool FitsKind(char letter, Scalar kind) {
  switch (letter) {
    case 'f':
    case 'r': return IsFloat(kind);
    case 'n': return kind != Scalar::kBool;
    case 'b': return kind == Scalar::kBool;
    case 'i': return IsInteger(kind) && !IsUnsigned(kind);
    case 'u': return IsInteger(kind) && IsUnsigned(kind);
    case 'd': return kind == Scalar::kDouble;
    case 'w': return IsInteger(kind);
    default: return true;
  }
}

bool FitsShape(char shape, const Type& type) {
  using enum TypeKind;
  switch (shape) {
    case 'g': return type.IsNumeric();
    case 'v': return type.kind == kVector || type.kind == kScalar;
    case '2':
    case '3':
    case '4': return type.kind == kVector && type.columns == shape - '0';
    case 's': return type.kind == kScalar;
    case 'q': return type.kind == kMatrix && type.rows == type.columns;
    default: return type.kind == kMatrix;  // m, t
  }
}

// Compares the types of one call with a signature of intrinsics.def, slot by slot.
class Matcher {
 public:
  explicit Matcher(const TypeTable& types) : types_(types) {}

  bool Match(IntrinsicSlot slot, TypeId id) {
    auto [shape, kind, is_out] = slot;
    const Type& type = types_[id];
    if (shape == 0) return type.kind == TypeKind::kVoid;
    if (!FitsShape(shape, type) || !FitsKind(kind, type.scalar)) return false;
    if (kind == 'f' || kind == 'r' || kind == 'n' || kind == 'a') {
      if (kinds_[Slot(kind)] && kinds_[Slot(kind)] != 1 + static_cast<int>(type.scalar))
        return false;
      kinds_[Slot(kind)] = 1 + static_cast<int>(type.scalar);
    }
    Type wanted = type;
    if (shape == 't') {
      std::swap(wanted.rows, wanted.columns);
      shape = 'm';
    }
    if (shape != 'g' && shape != 'v' && shape != 'm') return true;
    std::optional<Type>& seen = shapes_[shape == 'g' ? 0 : shape == 'v' ? 1 : 2];
    if (!seen) seen = wanted;
    return seen->kind == wanted.kind && seen->rows == wanted.rows &&
           seen->columns == wanted.columns;
  }

 private:
  static std::size_t Slot(char kind) {
    return kind == 'f' || kind == 'r' ? 0 : kind == 'n' ? 1 : 2;
  }

  const TypeTable& types_;
  std::array<int, 3> kinds_{};
  std::array<std::optional<Type>, 3> shapes_;
};

bool MatchesSignature(const TypeTable& types, const IntrinsicSignature& signature, TypeId result,
                      const std::vector<TypeId>& arguments) {
  if (arguments.size() != signature.count) return false;
  Matcher matcher(types);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!matcher.Match(signature.arguments[i], arguments[i])) return false;
  }
  return matcher.Match(signature.result, result);
}

// Whether the types are those of mul(): scalars, vectors and matrices in all nine combinations, of
// one kind.
bool MatchesMul(const Type& result, const Type& left, const Type& right) {
  using enum TypeKind;
  if (!left.IsNumeric() || !right.IsNumeric()) return false;
  if (left.scalar != right.scalar || left.scalar != result.scalar) return false;
  const bool left_vector = left.kind == kVector;
  const bool right_vector = right.kind == kVector;
  if (left.kind == kScalar) return SameShape(result, right);
  if (right.kind == kScalar) return SameShape(result, left);
  if (left_vector && right_vector) return left.columns == right.columns && result.kind == kScalar;
  if (left_vector) {
    return left.columns == right.rows && result.kind == kVector && result.columns == right.columns;
  }
  if (right_vector) {
    return left.columns == right.columns && result.kind == kVector && result.columns == left.rows;
  }
  return left.columns == right.rows && result.kind == kMatrix && result.rows == left.rows &&
         result.columns == right.columns;
}

// Whether the types are those of a function that no signature describes: mul, asfloat, asint and
// asuint.
bool MatchesSpecial(const TypeTable& types, Intrinsic op, TypeId result_id,
                    const std::vector<TypeId>& arguments) {
  using enum Scalar;
  const Type& result = types[result_id];
  if (arguments.empty()) return false;
  const Type& first = types[arguments[0]];
  if (op == Intrinsic::kInputOfVertex || op == Intrinsic::kOutputOfPoint)
    return arguments.size() == 2 && result_id == arguments[0] &&
           types[arguments[1]].kind == TypeKind::kScalar && IsInteger(types[arguments[1]].scalar);
  if (op == Intrinsic::kMul)
    return arguments.size() == 2 && MatchesMul(result, first, types[arguments[1]]);
  const Scalar from = BaseOf(first.scalar);
  if (arguments.size() == 3) {
    return op == Intrinsic::kAsUint && result.kind == TypeKind::kVoid && from == kDouble &&
           SameShape(first, types[arguments[1]]) && types[arguments[1]].scalar == kUint &&
           arguments[1] == arguments[2];
  }
  const Scalar to = op == Intrinsic::kAsFloat ? kFloat : op == Intrinsic::kAsInt ? kInt : kUint;
  const bool is_from_integer = from == kInt || from == kUint;
  return arguments.size() == 1 && SameShape(result, first) && BaseOf(result.scalar) == to &&
         (to == kFloat ? is_from_integer : from == kFloat);
}

}  // namespace

std::optional<std::string> CheckIntrinsic(const TypeTable& types, Intrinsic op, TypeId result,
                                          const std::vector<TypeId>& arguments) {
  const IntrinsicInfo& info = InfoOf(op);
  const bool fits = info.signature.is_special
                        ? MatchesSpecial(types, op, result, arguments)
                        : MatchesSignature(types, info.signature, result, arguments);
  if (fits) return std::nullopt;
  std::string text =
      std::string("the types do not fit ") + info.name + " (" + info.signature_text + "): ";
  text += types.Name(result) + "(";
  for (std::size_t i = 0; i < arguments.size(); ++i)
    text += (i == 0 ? "" : ", ") + types.Name(arguments[i]);
  return text + ")";
}

}  // namespace clipc::ir
