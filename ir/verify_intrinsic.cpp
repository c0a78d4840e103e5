// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <array>
#include <utility>

#include "ir/verifier.h"

namespace clipc::ir {
namespace {

const char* SignatureOf(Intrinsic op) {
  static constexpr const char* kSignatures[] = {
#define INTRINSIC(Enumerator, HlslName, Signature) Signature,
#include "ir/intrinsics.def"
#undef INTRINSIC
  };
  return kSignatures[static_cast<std::size_t>(op)];
}

bool FitsKind(char letter, Scalar kind) {
  switch (letter) {
    case 'f': return IsFloat(kind);
    case 'n': return kind != Scalar::kBool;
    case 'b': return kind == Scalar::kBool;
    case 'i': return IsInteger(kind) && !IsUnsigned(kind);
    case 'u': return IsInteger(kind) && IsUnsigned(kind);
    case 'd': return kind == Scalar::kDouble;
    default: return true;
  }
}

bool FitsShape(char letter, const Type& type) {
  switch (letter) {
    case 'g': return type.IsNumeric();
    case 'v': return type.kind == TypeKind::kVector || type.kind == TypeKind::kScalar;
    case '3': return type.kind == TypeKind::kVector && type.columns == 3;
    case '4': return type.kind == TypeKind::kVector && type.columns == 4;
    case 's': return type.kind == TypeKind::kScalar;
    case 'q': return type.kind == TypeKind::kMatrix && type.rows == type.columns;
    default: return type.kind == TypeKind::kMatrix;  // m, t
  }
}

// Holds the types of one call against a signature of intrinsics.def, letter by letter.
class Matcher {
 public:
  explicit Matcher(const TypeTable& types) : types_(types) {}

  bool Match(char shape, char kind, TypeId id) {
    const Type& type = types_[id];
    if (!FitsShape(shape, type) || !FitsKind(kind, type.scalar)) return false;
    if (kind == 'f' || kind == 'n' || kind == 'a') {
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
  static std::size_t Slot(char kind) { return kind == 'f' ? 0 : kind == 'n' ? 1 : 2; }

  const TypeTable& types_;
  std::array<int, 3> kinds_{};
  std::array<std::optional<Type>, 3> shapes_;
};

bool MatchesSignature(const TypeTable& types, std::string_view signature, TypeId result,
                      const std::vector<TypeId>& arguments) {
  Matcher matcher(types);
  const std::size_t open = signature.find('(');
  std::string_view rest = signature.substr(open + 1);
  for (TypeId argument : arguments) {
    if (!rest.empty() && rest.front() == 'o') rest.remove_prefix(1);
    if (rest.size() < 3 || !matcher.Match(rest[0], rest[1], argument)) return false;
    rest.remove_prefix(3);  // two letters and the comma or the closing parenthesis
  }
  if (!rest.empty()) return false;
  if (signature.starts_with("void")) return types[result].kind == TypeKind::kVoid;
  return matcher.Match(signature[0], signature[1], result);
}

// mul(): scalars, vectors and matrices in all nine combinations, of one kind.
bool MatchesMul(const Type& result, const Type& left, const Type& right) {
  if (!left.IsNumeric() || !right.IsNumeric()) return false;
  if (left.scalar != right.scalar || left.scalar != result.scalar) return false;
  const bool left_vector = left.kind == TypeKind::kVector;
  const bool right_vector = right.kind == TypeKind::kVector;
  if (left.kind == TypeKind::kScalar) return SameShape(result, right);
  if (right.kind == TypeKind::kScalar) return SameShape(result, left);
  if (left_vector && right_vector)
    return left.columns == right.columns && result.kind == TypeKind::kScalar;
  if (left_vector) {
    return left.columns == right.rows && result.kind == TypeKind::kVector &&
           result.columns == right.columns;
  }
  if (right_vector) {
    return left.columns == right.columns && result.kind == TypeKind::kVector &&
           result.columns == left.rows;
  }
  return left.columns == right.rows && result.kind == TypeKind::kMatrix &&
         result.rows == left.rows && result.columns == right.columns;
}

bool MatchesSpecial(const TypeTable& types, Intrinsic op, TypeId result_id,
                    const std::vector<TypeId>& arguments) {
  const Type& result = types[result_id];
  if (arguments.empty()) return false;
  const Type& first = types[arguments[0]];
  const Scalar from = BaseOf(first.scalar);
  const bool is_32_bits = from == Scalar::kFloat || from == Scalar::kInt || from == Scalar::kUint;
  const auto one_of_kind = [&](Scalar kind) {
    return arguments.size() == 1 && is_32_bits && SameShape(result, first) &&
           BaseOf(result.scalar) == kind;
  };
  switch (op) {
    case Intrinsic::kMul:
      return arguments.size() == 2 && MatchesMul(result, first, types[arguments[1]]);
    case Intrinsic::kAsFloat: return one_of_kind(Scalar::kFloat);
    case Intrinsic::kAsInt: return one_of_kind(Scalar::kInt);
    case Intrinsic::kAsUint:
      if (arguments.size() == 1) return one_of_kind(Scalar::kUint);
      return arguments.size() == 3 && result.kind == TypeKind::kVoid && from == Scalar::kDouble &&
             SameShape(first, types[arguments[1]]) && types[arguments[1]].scalar == Scalar::kUint &&
             arguments[1] == arguments[2];
    case Intrinsic::kAsDouble:
      return arguments.size() == 2 && arguments[0] == arguments[1] && from == Scalar::kUint &&
             SameShape(result, first) && result.scalar == Scalar::kDouble;
    case Intrinsic::kFirstBitHigh:
      return arguments.size() == 1 && IsInteger(first.scalar) && SameShape(result, first) &&
             IsInteger(result.scalar);
    default: return true;
  }
}

}  // namespace

std::optional<std::string> CheckIntrinsic(const TypeTable& types, Intrinsic op, TypeId result,
                                          const std::vector<TypeId>& arguments) {
  const std::string_view signature = SignatureOf(op);
  const bool fits = signature == "special" ? MatchesSpecial(types, op, result, arguments)
                                           : MatchesSignature(types, signature, result, arguments);
  if (fits) return std::nullopt;
  std::string text =
      "the types do not fit " + std::string(NameOf(op)) + " (" + std::string(signature) + "): ";
  text += types.Name(result) + "(";
  for (std::size_t i = 0; i < arguments.size(); ++i)
    text += (i == 0 ? "" : ", ") + types.Name(arguments[i]);
  return text + ")";
}

}  // namespace clipc::ir
