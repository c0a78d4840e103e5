// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/conversion.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

namespace clipc::typing {
namespace {

bool IsSingle(const Type& type) { return type.Components() == 1; }
bool IsRowOrColumn(const Type& type) { return type.rows == 1 || type.columns == 1; }

// Whether the components of `from` fill `to` by splatting, truncating or being read in another
// shape. fxc and DXC share the rules; DXC's test conversions-between-type-shapes.hlsl lists them.
bool FitsShape(const Type& from, const Type& to) {
  const std::uint32_t have = from.Components();
  const std::uint32_t want = to.Components();
  if (have == 1 || want == 1) return true;
  const bool from_matrix = from.kind == TypeKind::kMatrix;
  const bool to_matrix = to.kind == TypeKind::kMatrix;
  if (from_matrix && to_matrix) return to.rows <= from.rows && to.columns <= from.columns;
  if (from_matrix) return have == want || (IsRowOrColumn(from) && want < have);
  if (to_matrix) return have == want || (IsRowOrColumn(to) && want < have);
  return want <= have;
}

// The bits of a kind, for comparing floats with floats, and other kinds with other kinds.
int WidthOf(Scalar kind) {
  switch (kind) {
    case Scalar::kBool: return 0;
    case Scalar::kMin10Float: return 10;
    case Scalar::kMin12Int: return 12;
    case Scalar::kMin16Float:
    case Scalar::kMin16Int:
    case Scalar::kMin16Uint: return 16;
    case Scalar::kHalf: return 17;  // after min16float, before float
    default: return IsWide(kind) ? 64 : 32;
  }
}

// The value of ConversionRank::kind.
std::uint8_t RankKind(Scalar from, Scalar to) {
  constexpr std::uint8_t kSame = 0, kPromotion = 1, kToSigned = 2, kToUnsigned = 3, kLossy = 4,
                         kOther = 5;
  if (from == to) return kSame;
  if (to == Scalar::kBool) return kLossy;
  if (from == Scalar::kBool) return kOther;
  if (IsFloat(from) != IsFloat(to)) return IsFloat(from) ? kLossy : kOther;
  if (WidthOf(to) < WidthOf(from)) return kLossy;
  if (IsUnsigned(from) != IsUnsigned(to)) return IsUnsigned(to) ? kToUnsigned : kToSigned;
  return kPromotion;
}

constexpr int kMaxSteps = 4 * kMaxLeaves;

// A scalar or an object, of which the type counts.
struct Leaf {
  Scalar kind;
  TypeId object = {};
  friend bool operator==(const Leaf&, const Leaf&) = default;
};

// A collector of the leaves of a type. It gives up after kMaxLeaves, and on types that are nested
// too deeply or have too many parts without leaves.
class LeafCollector {
 public:
  explicit LeafCollector(const TypeTable& types) : types_(types) {}

  bool Add(TypeId id, int depth = 0) {
    constexpr int kMaxDepth = 64;
    if (depth > kMaxDepth || ++steps_ > kMaxSteps) return false;
    const Type type = types_[id];
    switch (type.kind) {
      case TypeKind::kScalar:
      case TypeKind::kVector:
      case TypeKind::kMatrix:
        leaves_.insert(leaves_.end(), type.Components(), Leaf{type.scalar});
        return leaves_.size() <= kMaxLeaves;
      case TypeKind::kObject:
        leaves_.push_back({type.scalar, id});
        return leaves_.size() <= kMaxLeaves;
      case TypeKind::kArray:
        for (std::uint32_t i = 0; i < type.count; ++i) {
          if (!Add(type.element, depth + 1)) return false;
        }
        return true;
      case TypeKind::kStruct:
        for (const Field& field : types_[type.structure].fields) {
          if (!Add(field.type, depth + 1)) return false;
        }
        return true;
      default: return false;
    }
  }
  std::vector<Leaf> Take() { return std::move(leaves_); }

 private:
  const TypeTable& types_;
  std::vector<Leaf> leaves_;
  int steps_ = 0;
};

// The leaves of a type; nullopt if the collector gives up.
std::optional<std::vector<Leaf>> LeavesOf(const TypeTable& types, TypeId type) {
  LeafCollector collector(types);
  if (!collector.Add(type)) return std::nullopt;
  return collector.Take();
}

// The number of leaves that LeavesOf finds, without a list of them; more than kMaxLeaves if it
// gives up.
std::uint64_t LeafCount(const TypeTable& types, TypeId id, int& budget) {
  if (--budget < 0) return kMaxLeaves + 1;
  const Type& type = types[id];
  if (type.kind == TypeKind::kArray) return type.count * LeafCount(types, type.element, budget);
  if (type.kind != TypeKind::kStruct) return type.IsNumeric() ? type.Components() : 1;
  std::uint64_t count = 0;
  for (const Field& field : types[type.structure].fields) {
    count += LeafCount(types, field.type, budget);
    if (count > kMaxLeaves) break;
  }
  return count;
}

bool MayHaveSameLeaves(const TypeTable& types, TypeId left, TypeId right) {
  int left_budget = kMaxSteps, right_budget = kMaxSteps;
  const std::uint64_t count = LeafCount(types, left, left_budget);
  return count <= kMaxLeaves && count == LeafCount(types, right, right_budget);
}

// Whether a type is made of numbers only, however large it is.
bool IsNumericThroughout(const TypeTable& types, TypeId id, int& budget) {
  if (--budget < 0) return false;
  const Type& type = types[id];
  if (type.IsNumeric()) return true;
  if (type.kind == TypeKind::kArray) return IsNumericThroughout(types, type.element, budget);
  if (type.kind != TypeKind::kStruct) return false;
  const auto& fields = types[type.structure].fields;
  return std::ranges::all_of(
      fields, [&](const Field& field) { return IsNumericThroughout(types, field.type, budget); });
}

bool IsAggregate(const Type& type) {
  return type.kind == TypeKind::kStruct || type.kind == TypeKind::kArray;
}

// Whether `derived` starts with the fields of `base`, as a struct that inherits from it does.
bool IsBaseOf(const TypeTable& types, const Type& base, const Type& derived) {
  if (base.kind != TypeKind::kStruct || derived.kind != TypeKind::kStruct) return false;
  const auto& want = types[base.structure].fields;
  const auto& have = types[derived.structure].fields;
  return !want.empty() && want.size() < have.size() &&
         std::equal(
             want.begin(), want.end(), have.begin(),
             [](const Field& a, const Field& b) { return a.name == b.name && a.type == b.type; });
}

// Whether a sampler of one kind can be passed as another. Direct3D 9's `sampler` stands for a
// sampler of any dimension: a parameter `sampler2D s` takes it.
bool FitsObject(const Type& from, const Type& to) {
  return from.kind == TypeKind::kObject && to.kind == TypeKind::kObject &&
         from.object == ObjectKind::kSampler && IsCombinedSampler(to.object);
}

}  // namespace

Scalar CommonKind(Scalar left, Scalar right) {
  if (left == right) return left;
  if (IsFloat(left) != IsFloat(right))
    return IsFloat(left) ? left : right;  // an integer follows the float: min16float + int
  if (left == Scalar::kBool) return right;
  if (right == Scalar::kBool) return left;
  const int bits = std::max(WidthOf(left), WidthOf(right));
  if (IsFloat(left)) return WidthOf(left) == bits ? left : right;
  const bool is_unsigned = IsUnsigned(left) || IsUnsigned(right);
  switch (bits) {
    case 12: return Scalar::kMin12Int;
    case 16: return is_unsigned ? Scalar::kMin16Uint : Scalar::kMin16Int;
    case 64: return is_unsigned ? Scalar::kUint64 : Scalar::kInt64;
    default: return is_unsigned ? Scalar::kUint : Scalar::kInt;
  }
}

std::optional<std::vector<Scalar>> Flatten(const TypeTable& types, TypeId type) {
  const auto leaves = LeavesOf(types, type);
  if (!leaves || std::ranges::any_of(*leaves, [](Leaf leaf) { return bool{leaf.object}; }))
    return std::nullopt;
  std::vector<Scalar> kinds;
  for (const Leaf& leaf : *leaves) kinds.push_back(leaf.kind);
  return kinds;
}

std::optional<ConversionRank> RankImplicit(const TypeTable& types, TypeId from_id, TypeId to_id) {
  if (from_id == to_id || from_id == types.Error() || to_id == types.Error())
    return ConversionRank{};
  const Type& from = types[from_id];
  const Type& to = types[to_id];
  if (from.IsNumeric() && to.IsNumeric()) {
    if (!FitsShape(from, to)) return std::nullopt;
    ConversionRank rank{.kind = RankKind(from.scalar, to.scalar)};
    if (to.Components() < from.Components()) {
      rank.truncation = 1;
    } else if (to.Components() > from.Components()) {
      rank.splat = 1;
    } else {
      rank.form = from.kind != to.kind;
    }
    return rank;
  }
  // A struct converts to a struct or array with the very same leaves; never to or from a number
  // (X3017).
  if (IsAggregate(from) && IsAggregate(to)) {
    if (IsBaseOf(types, to, from)) return ConversionRank{.kind = 1, .form = 1};
    if (!MayHaveSameLeaves(types, from_id, to_id)) return std::nullopt;
    const auto have = LeavesOf(types, from_id);
    if (!have || have->empty() || have != LeavesOf(types, to_id)) return std::nullopt;
    return ConversionRank{.form = 1};
  }
  if (FitsObject(from, to)) return ConversionRank{.form = 1};
  return std::nullopt;
}

bool IsExplicitlyConvertible(const TypeTable& types, TypeId from_id, TypeId to_id) {
  if (RankImplicit(types, from_id, to_id) || to_id == types.Void()) return true;
  const Type& from = types[from_id];
  const Type& to = types[to_id];
  if (!IsAggregate(from) && !IsAggregate(to)) return false;
  if (IsSingle(from)) {
    int budget = kMaxLeaves;
    return IsNumericThroughout(types, to_id, budget);
  }
  const auto want = LeavesOf(types, to_id);
  const auto have = LeavesOf(types, from_id);
  if (!want || !have || want->empty() || want->size() > have->size()) return false;
  return std::ranges::equal(*want, std::span(*have).first(want->size()), {}, &Leaf::object,
                            &Leaf::object);
}

std::optional<TypeId> CommonType(TypeTable& types, TypeId left_id, TypeId right_id) {
  if (left_id == right_id) return left_id;
  if (left_id == types.Error() || right_id == types.Error()) return types.Error();
  const Type left = types[left_id];
  const Type right = types[right_id];
  if (!left.IsNumeric() || !right.IsNumeric()) return std::nullopt;
  const Scalar kind = CommonKind(left.scalar, right.scalar);
  if (IsSingle(left) && IsSingle(right)) {
    const bool use_right = left.kind != TypeKind::kScalar && right.kind == TypeKind::kScalar;
    return types.WithScalar(use_right ? right_id : left_id, kind);
  }
  // The common type is the larger type if the other fits it, else the smaller one; the left type of
  // two equally large ones.
  const bool left_is_larger = left.Components() >= right.Components();
  const auto& [larger, larger_id] =
      left_is_larger ? std::tie(left, left_id) : std::tie(right, right_id);
  const auto& [smaller, smaller_id] =
      left_is_larger ? std::tie(right, right_id) : std::tie(left, left_id);
  if (FitsShape(smaller, larger)) return types.WithScalar(larger_id, kind);
  if (FitsShape(larger, smaller)) return types.WithScalar(smaller_id, kind);
  return std::nullopt;
}

}  // namespace clipc::typing
